import type { Page } from '@playwright/test';
import type { Camera, Scene, WebGLRenderer } from 'three';

/** Exports of a figure of the living thesis. */
interface FigureModule {
  prepare?(): Promise<unknown>;
  readonly figure: { draw(): void; settled(): Promise<void> };
  readonly webgl: WebGLRenderer;
}

/** A window with a figure. */
export interface FigureWindow<Exports = object> {
  readonly live: Promise<FigureModule & Exports>;
}

/** Further exports of figures whose sums are compared with stock three. */
export interface ComparedFigure {
  readonly camera: Camera;
  readonly scene: Scene;
}
type Terms = Record<'ambient' | 'diffuse' | 'specular', boolean>;
export interface PhongFigure extends ComparedFigure {
  alone(term: keyof Terms): Terms;
  set(terms: Terms): void;
}
export interface MultipassFigure extends ComparedFigure {
  readonly LIGHTS: number;
  drawPass(pass: number): void;
  drawSum(count: number): void;
}

/** A picture of the canvas, RGBA of 8 bits, bottom row first. */
export interface FigurePicture {
  readonly width: number;
  readonly height: number;
  readonly data: readonly number[];
}

/** Opens a figure, on a clock that stands still, and waits until its picture lacks nothing. */
export async function openFigure(page: Page, name: string, query = ''): Promise<void> {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.goto(`./?thesis/${name}${query}&still=0`);
  await settle(page);
}

/** Waits until what the figure shows is there, and drawn. */
export const settle = (page: Page): Promise<void> =>
  page.evaluate(async () => {
    const module = await (window as unknown as FigureWindow).live;
    await module.prepare?.();
    await module.figure.settled();
  });

/** Draws the figure and reads its canvas. */
export async function readFigure(page: Page): Promise<FigurePicture> {
  return page.evaluate(async () => {
    const { figure, webgl } = await (window as unknown as FigureWindow).live;
    const gl = webgl.getContext();
    figure.draw();
    const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
    const data = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
    return { width, height, data: [...data] };
  });
}

/** Draws the figure; a number that stands for its pixels. */
export const figureHash = (page: Page): Promise<number> =>
  page.evaluate(async () => {
    const { figure, webgl } = await (window as unknown as FigureWindow).live;
    const gl = webgl.getContext();
    figure.draw();
    const data = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
    gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, data);
    // FNV-1a
    let hash = 0x811c9dc5;
    for (const byte of data) hash = Math.imul(hash ^ byte, 0x01000193);
    return hash >>> 0;
  });
