import { NoToneMapping, type Plane, type Scene, Vector4, type WebGLRenderer } from 'three';
import type { Session } from '../model/Session';

const viewport = new Vector4();
const noPlanes: Plane[] = [];

/** Draws a scene over the page's picture with the session's camera; the renderer's state and `info` are restored. */
export function drawOver({ webgl, camera, view }: Session, render: WebGLRenderer['render'], scene: Scene): void {
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
    const ratio = webgl.getPixelRatio();
    const [width, height] = [webgl.domElement.width / ratio, webgl.domElement.height / ratio];
    webgl.setViewport(view.x * width, view.y * height, view.z * width, view.w * height);
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
