import './example.css';
import { type FarolRenderer, type TechniqueName, techniques } from '@farol/renderer';
import type { AttachedEditor } from '@farol/attach';
import type { Camera, Scene, WebGLRenderer } from 'three';

/** Who draws: a technique of Farol's, or three's own renderer. */
export type Drawer = TechniqueName | 'three';

export interface ExampleOptions {
  /** Its canvas fills the page. */
  webgl: WebGLRenderer;
  farol: FarolRenderer;
  /** Draws one frame. @param byFarol - false: as it was before Farol @param seconds - time on the page's clock */
  frame(byFarol: boolean, seconds: number): void;
  /** Takes the size of the page (CSS pixels); the canvas has it already. */
  resize(width: number, height: number): void;
  /** Frames can be drawn when this is fulfilled. Default: at once. */
  ready?: Promise<unknown>;
}

/** What the page offers to the browser tests, as `window.example`. */
export interface Example {
  ready: Promise<void>;
  readonly farol: FarolRenderer;
  readonly webgl: WebGLRenderer;
  /** Draws the page as it is at 1 s, and gives what is on the canvas. */
  draw(by: Drawer): CanvasPixels | Promise<CanvasPixels>;
  /** Where an editor is attached: it, and what the page draws. */
  readonly editor?: AttachedEditor | null;
  readonly scene?: Scene;
  readonly camera?: Camera;
  /** Of a page that shows one of several things: their names, and another of them. */
  readonly parts?: readonly string[];
  show?(part: string): Promise<void>;
  /** Of a page of components: how many FarolRenderers it has made, and one more component that waits for something. */
  readonly made?: number;
  suspend?(promise: Promise<unknown>): void;
}

export interface CanvasPixels {
  width: number;
  height: number;
  /** [height, width, 4], RGBA as the screen shows it, bottom row first. */
  data: Uint8Array;
}

declare global {
  interface Window {
    example: Example;
  }
}

/** Who draws first: `?technique=` (or `three`); 'auto' for what there is not. */
export function askedDrawer(): Drawer {
  const asked = new URLSearchParams(location.search).get('technique');
  const isKnown = asked !== null && (asked === 'three' || Object.hasOwn(techniques, asked));
  return isKnown ? (asked as Drawer) : 'auto';
}

const STILL_AT = 1;

/**
 * What the examples have in common: a menu of who draws, the size of the window, and the loop. Nothing of it is needed to
 * use Farol. `?technique=` (or `three`) chooses who draws first; `?still` draws one frame and waits.
 */
export function examplePage({ webgl, farol, frame, resize, ready = Promise.resolve() }: ExampleOptions): void {
  const address = new URLSearchParams(location.search);
  const select = document.createElement('select');
  select.ariaLabel = 'Drawn by';
  select.append(
    new Option("three's own renderer", 'three'),
    ...Object.entries(techniques).map(([name, { label }]) => new Option(`Farol: ${label}`, name)),
  );
  select.value = askedDrawer();
  document.querySelector('nav')!.append(select);

  const draw = (by: Drawer, seconds: number) => {
    if (by !== 'three') farol.technique = by;
    frame(by !== 'three', seconds);
  };
  const drawChosen = (seconds: number) => draw(select.value as Drawer, seconds);
  const fit = () => {
    webgl.setSize(innerWidth, innerHeight);
    resize(innerWidth, innerHeight);
  };
  fit();

  const still = address.has('still');
  const started = ready.then(() => {
    addEventListener('resize', () => {
      fit();
      if (still) drawChosen(STILL_AT);
    });
    if (still) drawChosen(STILL_AT);
    else webgl.setAnimationLoop((milliseconds) => drawChosen(milliseconds / 1000));
  });
  window.example = {
    ready: started,
    farol,
    webgl,
    draw(by) {
      draw(by, STILL_AT);
      return readCanvas(webgl);
    },
  };
}

/** What is on the canvas; to be called before the browser shows it. */
export function readCanvas(webgl: WebGLRenderer): CanvasPixels {
  const gl = webgl.getContext();
  const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
  const data = new Uint8Array(width * height * 4);
  webgl.setRenderTarget(null);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
  return { width, height, data };
}
