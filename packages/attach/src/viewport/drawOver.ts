import { type Camera, NoToneMapping, type Plane, type Scene, Vector4, type WebGLRenderer } from 'three';

const viewport = new Vector4();
const noPlanes: Plane[] = [];

/** Draws a scene over what is on the canvas, and leaves the renderer, with its figures, as it was. */
export function drawOver(webgl: WebGLRenderer, render: WebGLRenderer['render'], scene: Scene, camera: Camera): void {
  const { autoClear, toneMapping, clippingPlanes, info } = webgl;
  const { autoReset } = info;
  const { frame, calls, triangles, points, lines } = info.render;
  const target = webgl.getRenderTarget();
  const [face, level] = [webgl.getActiveCubeFace(), webgl.getActiveMipmapLevel()];
  const scissorTest = webgl.getScissorTest();
  webgl.getViewport(viewport);
  try {
    Object.assign(webgl, { autoClear: false, toneMapping: NoToneMapping, clippingPlanes: noPlanes });
    info.autoReset = false;
    webgl.setRenderTarget(null);
    webgl.setScissorTest(false);
    const { width, height } = webgl.domElement;
    const ratio = webgl.getPixelRatio();
    webgl.setViewport(0, 0, width / ratio, height / ratio);
    render.call(webgl, scene, camera);
  } finally {
    webgl.setViewport(viewport);
    webgl.setScissorTest(scissorTest);
    webgl.setRenderTarget(target, face, level);
    info.autoReset = autoReset;
    Object.assign(info.render, { frame, calls, triangles, points, lines });
    Object.assign(webgl, { autoClear, toneMapping, clippingPlanes });
  }
}
