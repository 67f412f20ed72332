import { Camera, LinearToneMapping, NoToneMapping, Scene, type WebGLRenderer } from 'three';

const STOP = new Error('Farol: asked');

/** Whether the renderer was created with an `outputBufferType`, tested by a `render` that is stopped before it draws. */
export function hasOutputBuffer(webgl: WebGLRenderer): boolean {
  const scene = new Scene();
  const { toneMapping } = webgl;
  const target = webgl.getRenderTarget();
  let has = false;
  scene.onBeforeRender = () => {
    has = webgl.toneMapping === NoToneMapping; // with an output buffer, three tone maps when copying it to the canvas
    throw STOP; // stops before three clears
  };
  webgl.setRenderTarget(null);
  webgl.toneMapping = LinearToneMapping;
  try {
    webgl.render(scene, new Camera());
  } catch (error) {
    if (error !== STOP) throw error;
  } finally {
    webgl.toneMapping = toneMapping;
    webgl.setRenderTarget(target);
  }
  return has;
}
