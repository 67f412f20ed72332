import type { Vector2, Vector4 } from 'three';

/**
 * Computes the position of a pointer in the picture of a canvas.
 * @param canvas - may have padding, a border and a CSS scale
 * @param view - part of the canvas that the picture fills: left, bottom, width, height, as shares of the canvas's size
 * @param pointer - in CSS pixels, relative to the window
 * @param at - receives normalised device coordinates: -1 to 1 within the picture, y up
 */
export function locate(
  canvas: HTMLElement,
  view: Vector4,
  { clientX, clientY }: { readonly clientX: number; readonly clientY: number },
  at: Vector2,
): void {
  const { left, top, width, height } = canvas.getBoundingClientRect();
  const { offsetWidth, offsetHeight, clientWidth, clientHeight, clientLeft, clientTop } = canvas;
  const style = getComputedStyle(canvas);
  const [paddingLeft, paddingRight, paddingTop, paddingBottom] = [
    ...[style.paddingLeft, style.paddingRight, style.paddingTop, style.paddingBottom].map(
      (text) => parseFloat(text) || 0,
    ),
  ];
  const [scaleX, scaleY] = [width / (offsetWidth || 1), height / (offsetHeight || 1)];
  const frameWidth = (offsetWidth - clientWidth + paddingLeft + paddingRight) * scaleX;
  const frameHeight = (offsetHeight - clientHeight + paddingTop + paddingBottom) * scaleY;
  const x = (clientX - left - (clientLeft + paddingLeft) * scaleX) / (width - frameWidth);
  const y = 1 - (clientY - top - (clientTop + paddingTop) * scaleY) / (height - frameHeight);
  at.set(((x - view.x) / view.z) * 2 - 1, ((y - view.y) / view.w) * 2 - 1);
}
