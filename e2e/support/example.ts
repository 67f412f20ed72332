import type { Page } from '@playwright/test';
import type { AttachedEditor } from '@farol/attach';
import type { Camera, Scene, WebGLRenderer } from 'three';
import type { FarolRenderer } from '@farol/renderer';
import type { FloatImage } from './images';

/** `window.example` as far as the tests use it; e2e/pages/examples/shared/examplePage.ts. */
export interface ExampleHandle {
  readonly ready: Promise<void>;
  readonly farol: FarolRenderer;
  readonly webgl: WebGLRenderer;
  draw(by: string): Pixels | Promise<Pixels>;
  /** Attached editor of pages that have one. */
  readonly editor?: AttachedEditor | null;
  readonly scene?: Scene;
  readonly camera?: Camera;
  drawFrame?(seconds: number): void;
  /** Names of the things that a page can show, and a function that shows another one. */
  readonly parts?: readonly string[];
  show?(part: string): Promise<void>;
  /** Number of FarolRenderers that a page of components has made, and a function that suspends one more component. */
  readonly made?: number;
  suspend?(promise: Promise<unknown>): void;
}

interface Pixels {
  width: number;
  height: number;
  data: Uint8Array;
}

declare global {
  interface Window {
    example: ExampleHandle;
  }
}

/** Opens a page of e2e/pages/examples, standing still, and waits until it can draw. */
export async function openExample(page: Page, name: string, technique = 'deferred'): Promise<void> {
  await page.setViewportSize({ width: 320, height: 180 });
  await page.goto(`./examples/${name}/index.html?still&technique=${technique}`);
  await page.waitForFunction(() => 'example' in window);
  await page.evaluate(() => window.example.ready);
}

/** Picture of an example's canvas, drawn by a technique or by 'three'; decoded from sRGB to linear. */
export async function drawExample(page: Page, by: string): Promise<FloatImage> {
  const { width, height, text } = await page.evaluate(async (by) => {
    const { width, height, data } = await window.example.draw(by);
    const parts: string[] = [];
    for (let i = 0; i < data.length; i += 8192) parts.push(String.fromCharCode(...data.subarray(i, i + 8192)));
    return { width, height, text: btoa(parts.join('')) };
  }, by);
  return { width, height, data: Array.from(Buffer.from(text, 'base64'), (byte) => decodeSRGB(byte / 255)) };
}

/** The inverse of the sRGB transfer function. @see IEC 61966-2-1 */
function decodeSRGB(encoded: number): number {
  return encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4;
}
