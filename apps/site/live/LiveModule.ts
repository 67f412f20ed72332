import type { FarolRenderer } from '@farol/renderer';
import type { Camera, Scene, WebGLRenderer } from 'three';

/** Exports of a live module that the site and the tests know; all may be missing. */
export interface LiveModule {
  readonly farol?: FarolRenderer | Promise<FarolRenderer>;
  readonly webgl?: WebGLRenderer | Promise<WebGLRenderer>;
  readonly scene?: Scene | Promise<Scene>;
  readonly camera?: Camera | Promise<Camera>;
  /** Fulfilled when work that goes on for many frames, such as a bake, is done. */
  readonly ready?: Promise<unknown>;
  /** Worker that draws, whose global `live` has the other exports. */
  readonly worker?: Worker;
}
