import './example.css';
import { type FarolRenderer, type TechniqueName, techniques } from '@farol/renderer';
import type { AttachedEditor } from '@farol/attach';
import type { Camera, Scene, WebGLRenderer } from 'three';

/** Renderer of the page: a technique of Farol, or three's own. */
export type Drawer = TechniqueName | 'three';

export interface ExampleOptions {
  /** Its canvas fills the page. */
  webgl: WebGLRenderer;
  farol: FarolRenderer;
  /** Draws one frame. @param byFarol - false for stock three @param seconds - time of the page's clock */
  frame(byFarol: boolean, seconds: number): void;
  /** Called with the size of the page (CSS pixels) after the canvas got it. */
  resize(width: number, height: number): void;
  /** Fulfilled once frames can be drawn; missing if they can at once. */
  ready?: Promise<unknown>;
}

/** Interface for the browser tests, `window.example`. */
export interface Example {
  ready: Promise<void>;
  readonly farol: FarolRenderer;
  readonly webgl: WebGLRenderer;
  /** Draws the page at 1 s and reads the canvas. */
  draw(by: Drawer): CanvasPixels | Promise<CanvasPixels>;
  /** The attached editor and the page's scene, in examples with an editor. */
  readonly editor?: AttachedEditor | null;
  readonly scene?: Scene;
  readonly camera?: Camera;
  /** Names of the variants of an example, and a function that chooses one; missing if it has a single one. */
  readonly parts?: readonly string[];
  show?(part: string): Promise<void>;
  /** React examples: number of FarolRenderers made, and a function that adds a suspending component. */
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

/** Renderer of the first frame by `?technique=`; `auto` for an unknown one. */
export function askedDrawer(): Drawer {
  const asked = new URLSearchParams(location.search).get('technique');
  const isKnown = asked !== null && (asked === 'three' || Object.hasOwn(techniques, asked));
  return isKnown ? (asked as Drawer) : 'auto';
}

const STILL_AT = 1;

/**
 * Common parts of the examples, none of them needed to use Farol: a menu of techniques, the size of the window, the loop.
 * `?technique=` chooses a technique or `three`; `?still` draws one frame and waits.
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

/** Pixels of the canvas; valid until the browser presents the frame. */
export function readCanvas(webgl: WebGLRenderer): CanvasPixels {
  const gl = webgl.getContext();
  const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
  const data = new Uint8Array(width * height * 4);
  webgl.setRenderTarget(null);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
  return { width, height, data };
}
