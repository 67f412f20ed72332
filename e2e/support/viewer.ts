import type { Scene as EngineScene } from '@farol/engine';
import type { FarolRenderer } from '@farol/renderer';
import type { Page } from '@playwright/test';
import type { Camera, Scene, WebGLRenderer } from 'three';
import type { FloatImage } from './images';

/** `window.viewer` as far as the tests use it; documented in apps/viewer/src/main.ts. */
export interface ViewerHandle {
  readonly ready: Promise<void>;
  readonly farol: FarolRenderer;
  readonly three: WebGLRenderer;
  readonly scene: Scene;
  readonly camera: Camera;
  readonly engineScene: EngineScene;
  readonly state: { scene: string; technique: string; view: string; time: number | null; gui: boolean };
  readonly known: {
    scenes: Record<string, { parameters: object }>;
    techniques: readonly string[];
    views: readonly string[];
  };
  readonly modelName: string | null;
  renderAt(seconds: number): void;
  setTechnique(name: string): void;
  setView(name: string): void;
  loadScene(name: string, parameters?: Record<string, number | string | boolean>): Promise<void>;
  readPixels(): { width: number; height: number; data: Float32Array };
  readStockPixels(): { width: number; height: number; data: Float32Array };
}

declare global {
  interface Window {
    viewer: ViewerHandle;
  }
}

/** A small picture of a small scene that stands still: what most tests want. */
export const still = { scene: 'benchmarkLights', n: 4, m: 3, time: 1, width: 160, height: 90, dpr: 1, gui: 0 };

/** Opens the viewer with address parameters, and waits until its scene is there. */
export async function openViewer(page: Page, parameters: Record<string, string | number> = {}): Promise<void> {
  const query = new URLSearchParams(Object.entries(parameters).map(([name, value]) => [name, String(value)]));
  await page.goto(`./?${query}`);
  await page.waitForFunction(() => 'viewer' in window); // after texts of another language are fetched
  await page.evaluate(() => window.viewer.ready);
}

/** The viewer's picture as linear floats, drawn by Farol or by three's own renderer. */
export async function readImage(page: Page, by: 'farol' | 'three' = 'farol'): Promise<FloatImage> {
  const { width, height, text } = await page.evaluate((by) => {
    const { width, height, data } = by === 'three' ? window.viewer.readStockPixels() : window.viewer.readPixels();
    const bytes = new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
    const parts: string[] = [];
    for (let i = 0; i < bytes.length; i += 8192) parts.push(String.fromCharCode(...bytes.subarray(i, i + 8192)));
    return { width, height, text: btoa(parts.join('')) };
  }, by);
  const bytes = Buffer.from(text, 'base64');
  return { width, height, data: new Float32Array(new Uint8Array(bytes).buffer) };
}

/** Parameters of a page's address as they are now; `page.url()` is told of a change a while later. */
export const addressOf = async (page: Page): Promise<Readonly<Record<string, string>>> =>
  Object.fromEntries(new URLSearchParams(await page.evaluate(() => location.search)));
