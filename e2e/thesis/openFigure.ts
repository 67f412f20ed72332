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

/** Pixels of a figure's picture, as a number that stands for them and as what they are. */
export interface FigurePicture {
  readonly hash: number;
  /** Number of different colours. */
  readonly tones: number;
  /** Share of channels above 60 of 255. */
  readonly light: number;
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
export const readFigure = (page: Page): Promise<FigurePicture> =>
  page.evaluate(async () => {
    const { figure, webgl } = await (window as unknown as FigureWindow).live;
    const gl = webgl.getContext();
    figure.draw();
    const data = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
    gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, data);
    const tones = new Set<number>();
    let light = 0;
    let hash = 0x811c9dc5; // FNV-1a
    data.forEach((value, i) => {
      hash = Math.imul(hash ^ value, 0x01000193);
      if (i % 4 === 3) tones.add((data[i - 3] << 16) | (data[i - 2] << 8) | data[i - 1]);
      else if (value > 60) light++;
    });
    return { hash: hash >>> 0, tones: tones.size, light: light / data.length };
  });

/** A number that stands for the figure's pixels. */
export const figureHash = async (page: Page): Promise<number> => (await readFigure(page)).hash;
