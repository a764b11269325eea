/** A third-party page with an exported model: three.js and its loader, and none of our code. */
import {
  MeshBasicMaterial,
  OrthographicCamera,
  RepeatWrapping,
  Scene,
  Vector3,
  WebGLRenderer,
  type Mesh,
  type MeshStandardMaterial,
} from 'three';
import {GLTFLoader} from 'three/examples/jsm/loaders/GLTFLoader.js';

type Triple = readonly [number, number, number];

/** A viewer's data about a model, and the colours it draws. */
interface Opened {
  readonly names: readonly string[];
  readonly triangles: number;
  readonly repeats: boolean;
  readonly isDoubleSided: boolean;
  /** Red, green and blue from 0 to 255 at each place. */
  readonly colours: readonly Triple[];
}

declare global {
  var openModel: (model: string, places: readonly Triple[]) => Promise<Opened>;
}

/**
 * Side of the image, which shows `seen` metres about the middle of the model from the front. [px]
 */
const side = 1024;
const seen = 0.1;

globalThis.openModel = async (model, places) => {
  const bytes = Uint8Array.from(atob(model), (letter) => letter.charCodeAt(0));
  const {scene: root} = await new GLTFLoader().parseAsync(bytes.buffer, '');
  const garment = root.getObjectByName('garment') as Mesh;
  const {map, side: sides} = garment.material as MeshStandardMaterial;
  garment.geometry.computeBoundingBox();
  const middle = garment.geometry.boundingBox?.getCenter(new Vector3()) ?? new Vector3();
  const camera = new OrthographicCamera(-seen / 2, seen / 2, seen / 2, -seen / 2, 0, 2);
  camera.position.set(middle.x, middle.y, middle.z + 1);
  camera.updateMatrixWorld();
  const renderer = new WebGLRenderer({preserveDrawingBuffer: true});
  renderer.setSize(side, side, false);
  garment.material = new MeshBasicMaterial({map}); // the ink alone, in any light
  const scene = new Scene();
  scene.add(root);
  renderer.render(scene, camera);
  const context = renderer.getContext();
  return {
    names: root.children.map(({name}) => name),
    triangles: (garment.geometry.index?.count ?? 0) / 3,
    repeats: map?.wrapS === RepeatWrapping && map.wrapT === RepeatWrapping,
    isDoubleSided: sides === 2,
    colours: places.map((place) => {
      const {x, y} = new Vector3(...place).project(camera);
      const [column, row] = [x, y].map((at) => Math.floor(((at + 1) / 2) * side));
      const pixel = new Uint8Array(4);
      context.readPixels(column ?? 0, row ?? 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, pixel);
      const [r = 0, g = 0, b = 0] = pixel;
      return [r, g, b];
    }),
  };
};
