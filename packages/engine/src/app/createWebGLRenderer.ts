import { WebGLRenderer, type WebGLRendererParameters } from 'three';

/** Message for a user without WebGL 2, with the remedy. */
export const noWebGL2 =
  'This browser has no WebGL 2, which Farol needs. Switch hardware acceleration on in the settings of the ' +
  'browser, or update it; https://get.webgl.org/webgl2/ shows whether WebGL 2 works.';

/** Makes three's renderer. @throws Error that says what to do, where the browser has no WebGL 2 */
export function createWebGLRenderer(parameters?: WebGLRendererParameters): WebGLRenderer {
  try {
    return new WebGLRenderer(parameters);
  } catch (error) {
    throw document.createElement('canvas').getContext('webgl2') ? error : new Error(noWebGL2, { cause: error });
  }
}
