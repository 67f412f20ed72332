import { type ArrayCamera, type Camera, type PerspectiveCamera, Vector4, type WebGLRenderer } from 'three';

const viewport = new Vector4();
const scissor = new Vector4();
const part = new Vector4();

/**
 * Draws by each camera of an array, as three does: each into its `viewport` (pixels), into a target that is cleared once.
 * The host's viewport and scissor are put back.
 * @param render - draws by one camera, with its index
 */
export function renderArray(
  webgl: WebGLRenderer,
  { cameras }: ArrayCamera,
  render: (camera: Camera, i: number) => void,
): void {
  const target = webgl.getRenderTarget();
  const ratio = webgl.getPixelRatio();
  const setRectangles = (view: Vector4, cut: Vector4, test: boolean) => {
    if (target === null) {
      webgl.setViewport(view);
      webgl.setScissor(cut);
      webgl.setScissorTest(test);
    } else {
      target.viewport.copy(view);
      target.scissor.copy(cut);
      target.scissorTest = test;
      webgl.setRenderTarget(target, webgl.getActiveCubeFace(), webgl.getActiveMipmapLevel());
    }
  };
  const test = target === null ? webgl.getScissorTest() : target.scissorTest;
  const oldViewport = (target === null ? webgl.getViewport(viewport) : viewport.copy(target.viewport)).clone();
  const oldScissor = (target === null ? webgl.getScissor(scissor) : scissor.copy(target.scissor)).clone();
  try {
    cameras.forEach((camera: PerspectiveCamera & { viewport?: Vector4 }, i) => {
      part.copy(camera.viewport ?? oldViewport);
      if (camera.viewport !== undefined) part.roundToZero().divideScalar(target === null ? ratio : 1);
      if (part.z < 1 || part.w < 1) return;
      // the first camera clears the whole target, the others clear their viewports
      if (i === 0) setRectangles(part, oldScissor, test);
      else setRectangles(part, test ? common(part, oldScissor) : part, true);
      render(camera, i);
    });
  } finally {
    setRectangles(oldViewport, oldScissor, test);
  }
}

/** Intersection of two rectangles (x, y, width, height). */
function common(a: Vector4, b: Vector4): Vector4 {
  const x = Math.max(a.x, b.x);
  const y = Math.max(a.y, b.y);
  const width = Math.max(0, Math.min(a.x + a.z, b.x + b.z) - x);
  const height = Math.max(0, Math.min(a.y + a.w, b.y + b.w) - y);
  return scissor.set(x, y, width, height);
}
