import { Color, type WebGLRenderer } from 'three';

/** Uses the host's renderer for some work, then restores its state. */
export function keepState<T>(renderer: WebGLRenderer, work: () => T): T {
  const target = renderer.getRenderTarget();
  const [face, level] = [renderer.getActiveCubeFace(), renderer.getActiveMipmapLevel()];
  const { autoClear, info } = renderer;
  const { autoReset } = info;
  const clearColour = renderer.getClearColor(new Color());
  const clearAlpha = renderer.getClearAlpha();
  const isPresenting = renderer.xr.enabled;
  renderer.autoClear = false;
  renderer.xr.enabled = false;
  info.autoReset = false;
  renderer.setClearColor(0x000000, 0);
  try {
    return work();
  } finally {
    renderer.autoClear = autoClear;
    renderer.xr.enabled = isPresenting;
    info.autoReset = autoReset;
    renderer.setClearColor(clearColour, clearAlpha);
    renderer.setRenderTarget(target, face, level);
  }
}
