/** `<LiveGarment>`: the element of the package in a page of the site, with lists of samples. */
import {withBase} from 'vitepress';
import {defineComponent, h, onMounted, ref, type VNode} from 'vue';

interface Samples {
  readonly garments: readonly {readonly style: string; readonly title: string}[];
  readonly prints: readonly {readonly name: string; readonly title: string}[];
}

/** Values and texts of a list. */
type Options = readonly (readonly [value: string, text: string])[];

const sizes: Options = ['xs', 's', 'm', 'l', 'xl'].map((size) => [size, size.toUpperCase()]);

const garmentUrl = (style: string): string => withBase(`/garments/${style}-{size}.json`);
const printUrl = (name: string): string => withBase(`/prints/${name}.json`);

export const LiveGarment = defineComponent({
  props: {
    garment: {type: String, default: 'princess-dress'},
    print: {type: String, default: 'pmm'},
    view: {type: String, default: 'pattern'},
    mode: {type: String, default: 'preview'},
    /** Names of prints to choose from inside the element, with `mode="place"`. */
    prints: {type: Array<string>, default: undefined},
  },
  setup(props) {
    const garment = ref(props.garment);
    const print = ref(props.print);
    const size = ref('m');
    const samples = ref<Samples>();
    const status = ref('');

    onMounted(async () => {
      await import(/* @vite-ignore */ withBase('/seamwise/seamwise.js'));
      const answer = await fetch(withBase('/samples.json'));
      samples.value = (await answer.json()) as Samples;
    });

    const list = (label: string, chosen: typeof size, options: Options): VNode =>
      h('label', [
        h('span', label),
        h(
          'select',
          {
            value: chosen.value,
            onChange: ({target}: Event) => {
              chosen.value = (target as HTMLSelectElement).value;
            },
          },
          options.map(([value, text]) => h('option', {value}, text)),
        ),
      ]);

    const lists = ({garments, prints}: Samples): VNode[] => [
      list(
        'Garment',
        garment,
        garments.map(({style, title}) => [style, title]),
      ),
      list(
        'Print',
        print,
        prints.map(({name, title}) => [name, title]),
      ),
      list('Size', size, sizes),
    ];

    return () =>
      h('figure', {class: `live ${props.mode}`}, [
        h('div', {class: 'live-lists'}, [
          samples.value && lists(samples.value),
          h('output', status.value),
        ]),
        h('seamwise-garment', {
          garment: garmentUrl(garment.value),
          size: size.value,
          print: printUrl(print.value),
          view: props.view,
          mode: props.mode,
          alt: 'A sample garment in a sample print',
          ...(props.prints && {'.prints': props.prints.map(printUrl)}),
          onProgress: () => (status.value = 'Matching the print …'),
          onSolve: ({detail}: CustomEvent<{readonly milliseconds: number}>) =>
            (status.value = `Matched in ${(detail.milliseconds / 1000).toFixed(1)} s`),
          onError: ({detail}: CustomEvent<{readonly message: string}>) =>
            (status.value = detail.message),
        }),
      ]);
  },
});
