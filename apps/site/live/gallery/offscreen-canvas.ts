/**
 * Drawn in a worker
 *
 * A thousand moving lights through an `OffscreenCanvas`: the page sends sizes and pointers, and its thread stays free.
 *
 * @tags many lights, worker, canvas
 */
const canvas = document.querySelector('canvas')!;
const offscreen = canvas.transferControlToOffscreen();
const worker = new Worker(new URL('./offscreen-canvas/city.ts', import.meta.url), { type: 'module' });
const send = (message: object, transfer: Transferable[] = []) => worker.postMessage(message, transfer);

const size = () => ({ width: innerWidth, height: innerHeight, ratio: Math.min(devicePixelRatio, 2) });
send({ type: 'start', canvas: offscreen, size: size() }, [offscreen]);
addEventListener('resize', () => send({ type: 'resize', size: size() }));
// out of sight nothing is drawn
const observer = new IntersectionObserver(([{ isIntersecting }]) => send({ type: 'show', isIntersecting }));
observer.observe(canvas);

// a worker has no pointers: it is told of those over the canvas
canvas.style.touchAction = 'pan-y'; // sideways turns the city, up and down scrolls the page
for (const type of ['pointerdown', 'pointermove', 'pointerup', 'pointercancel'] as const)
  canvas.addEventListener(type, (event) => {
    if (type === 'pointerdown') canvas.setPointerCapture(event.pointerId);
    const { pointerId, pointerType, button, clientX, clientY, pageX, pageY, ctrlKey, metaKey, shiftKey } = event;
    const values = { pointerId, pointerType, button, clientX, clientY, pageX, pageY, ctrlKey, metaKey, shiftKey };
    send({ type: 'pointer', event: type, values });
  });
canvas.addEventListener('contextmenu', (event) => event.preventDefault());

/** Fulfilled when the worker has drawn: until then the site shows a picture. */
const ready = new Promise((resolve) => worker.addEventListener('message', resolve, { once: true }));

export { ready, worker };
