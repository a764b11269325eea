/** Drags a page of the sheet to another place; a click is no drag. */
import type {Point} from '../../model/geometry/vectors.js';

/** Distance from which a movement is a drag. [px] */
const least = 6;

interface PageDrag {
  /** Called for a press without movement. */
  readonly onClick: () => void;
  /** Called with the point of the sheet where the page is dropped. [mm] */
  readonly onDrop: (at: Point) => void;
}

/** Follows the pointer from its press on a page until it is released or cancelled. */
export function dragPage(down: PointerEvent, {onClick, onDrop}: PageDrag): void {
  const page = down.currentTarget as SVGGElement;
  const matrix = page.ownerSVGElement?.getScreenCTM();
  if (down.button !== 0 || !matrix) return;
  const inSheet = ({clientX, clientY}: PointerEvent): DOMPoint =>
    new DOMPoint(clientX, clientY).matrixTransform(matrix.inverse());
  const from = inSheet(down);
  const life = new AbortController();
  const {signal} = life;
  let isDrag = false;
  const end = (): void => {
    life.abort();
    page.removeAttribute('transform');
    page.classList.remove('dragged');
  };
  page.setPointerCapture(down.pointerId);
  page.addEventListener(
    'pointermove',
    (event) => {
      const off = Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY);
      isDrag ||= off >= least;
      if (!isDrag) return;
      const {x, y} = inSheet(event);
      page.classList.add('dragged');
      page.setAttribute('transform', `translate(${x - from.x} ${y - from.y})`);
    },
    {signal},
  );
  page.addEventListener(
    'pointerup',
    (event) => {
      const {x, y} = inSheet(event);
      end();
      if (isDrag) onDrop([x, -y]);
      else onClick();
    },
    {signal},
  );
  page.addEventListener('pointercancel', end, {signal});
}
