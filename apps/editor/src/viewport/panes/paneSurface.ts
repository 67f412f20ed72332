/** Rectangle on the page (CSS pixels). */
export interface Bounds {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/**
 * A proxy of a canvas that reports the rectangle of one view as its own, for controls that compute positions from it.
 */
export function paneSurface(canvas: HTMLCanvasElement, bounds: () => Bounds): HTMLCanvasElement {
  const rectangle = (): DOMRect => {
    const { left, top, width, height } = bounds();
    return new DOMRect(left, top, width, height);
  };
  return new Proxy(canvas, {
    get(target, key) {
      if (key === 'getBoundingClientRect') return rectangle;
      const value: unknown = Reflect.get(target, key, target);
      return typeof value === 'function' ? value.bind(target) : value;
    },
    set: (target, key, value) => Reflect.set(target, key, value, target),
  });
}
