/** Duration of a press (ms) before a finger drags an element; a finger that moves sooner scrolls. */
const REST = 350;

/** Distance (CSS pixels) that a pressing finger may move. */
const SHAKE = 8;

/** A point of the page (CSS pixels). */
interface Point {
  readonly x: number;
  readonly y: number;
}

/**
 * Lets a finger drag an element, which browsers support for mice only: after a long press a copy of the element follows
 * the finger.
 * @param drop - called with the point where the finger is lifted
 * @returns a function that removes the listeners
 */
export function watchFinger(element: HTMLElement, drop: (at: Point) => void): () => void {
  const end = new AbortController();
  let timer: ReturnType<typeof setTimeout> | undefined;
  let start: Point = { x: 0, y: 0 };
  /** Copy that follows the finger; null while nothing is dragged. */
  let copy: HTMLElement | null = null;

  const follow = ({ x, y }: Point): void => {
    if (copy) copy.style.transform = `translate(${x}px, ${y}px) translate(-50%, -100%)`;
  };
  const begin = (): void => {
    copy = element.cloneNode(true) as HTMLElement;
    copy.classList.add('library-dragged');
    copy.setAttribute('aria-hidden', 'true');
    copy.inert = true;
    // the copy is added inside the editor's element, so that it has the editor's theme
    (element.closest('.panel')?.parentElement ?? document.body).append(copy);
    follow(start);
  };
  const letGo = (): void => {
    clearTimeout(timer);
    copy?.remove();
    copy = null;
  };
  const on = <K extends keyof HTMLElementEventMap>(
    name: K,
    listen: (event: HTMLElementEventMap[K]) => void,
    options: AddEventListenerOptions = {},
  ): void => element.addEventListener(name, listen, { signal: end.signal, ...options });

  on('pointerdown', ({ pointerType, isPrimary, clientX, clientY }) => {
    letGo();
    if (pointerType !== 'touch' || !isPrimary) return;
    start = { x: clientX, y: clientY };
    timer = setTimeout(begin, REST);
  });
  on('pointermove', ({ clientX: x, clientY: y }) => {
    follow({ x, y });
    if (!copy && Math.hypot(x - start.x, y - start.y) > SHAKE) clearTimeout(timer);
  });
  on('pointerup', ({ clientX: x, clientY: y }) => {
    const wasDragged = copy !== null;
    letGo();
    if (wasDragged) drop({ x, y });
  });
  on('pointercancel', letGo);
  on('contextmenu', (event) => copy && event.preventDefault());
  // prevents scrolling during a drag
  on('touchmove', (event) => copy && event.preventDefault(), { passive: false });
  return () => {
    letGo();
    end.abort();
  };
}
