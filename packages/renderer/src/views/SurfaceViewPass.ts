import { Matrix4, Vector3, Vector4, type Material, type OrthographicCamera, type PerspectiveCamera } from 'three';
import type { View } from '../frame/views';
import type { Frame } from '../frame/Frame';
import { FullscreenPass } from '../gpu/FullscreenPass';
import type { GBuffer } from '../gbuffer/GBuffer';
import { GBufferTarget } from '../passes/gbuffer/GBufferTarget';
import { gbufferUniforms, setGBufferUniforms } from '../passes/gbuffer/gbufferUniforms';
import { litViewTwin, unlitViewTwin } from './gbufferViewTwins';
import { isPlain, type RenderItem } from '../frame/RenderItem';
import type { TwinKind } from '../materials/TwinKind';
import { setViewport } from '../three/state';

/** Values of `farol_view` in surfaceView.glsl, by view. */
const CODES: Partial<Record<View, number>> = {
  albedo: 0,
  normal: 1,
  depth: 2,
  position: 3,
  roughness: 4,
  metalness: 5,
  emissive: 6,
};

/** Position of each panel of 'grid', in halves of the viewport; the final picture is at the lower right (thesis 4.1). */
const PANELS = [
  { view: 'albedo', x: 0, y: 1 },
  { view: 'normal', x: 1, y: 1 },
  { view: 'depth', x: 0, y: 0 },
] as const;

const panel = new Vector4();

/** Twin kind that writes an item into the G-buffer of the surface views; null for items not shown there. */
function viewTwinOf(item: RenderItem): TwinKind | null {
  const m = item.material as Material & { isShaderMaterial?: boolean; isMeshBasicMaterial?: boolean };
  if (!isPlain(item)) return null;
  if (item.shading === 'lit' && m.isShaderMaterial !== true) return litViewTwin;
  return m.isMeshBasicMaterial === true ? unlitViewTwin : null;
}

/** Draws every mesh into a G-buffer, with any technique, and shows one of its properties, or three of them beside the picture. */
export class SurfaceViewPass {
  private readonly target = new GBufferTarget(false);
  private readonly surface = new FullscreenPass({
    program: 'surface view',
    fragment: 'surfaceView',
    shared: 'all',
    asThree: true,
    repeats: true,
    uniforms: {
      ...gbufferUniforms(),
      farol_view: { value: 0 },
      farol_depthRange: { value: new Vector3() },
      farol_viewInverse: { value: new Matrix4() },
    },
  });

  get bytes(): number {
    return this.target.bytes;
  }

  /** Shows `frame.view` over the viewport, or its panels for 'grid'. */
  render(frame: Frame): void {
    const gbuffer = this.fill(frame);
    const { uniforms } = this.surface;
    setGBufferUniforms(uniforms, gbuffer, frame);
    const camera = frame.camera as PerspectiveCamera & OrthographicCamera;
    const { near, far } = camera;
    const logarithmic = camera.isPerspectiveCamera && near > 0 && Number.isFinite(far);
    uniforms.farol_depthRange.value.set(near, Number.isFinite(far) ? far : near + 1000, logarithmic ? 1 : 0);
    uniforms.farol_viewInverse.value.copy(camera.matrixWorldInverse).invert();
    frame.bindTarget();
    const { viewport } = frame;
    if (frame.view !== 'grid') {
      this.draw(frame, CODES[frame.view] ?? 0, viewport);
      return;
    }
    // the final picture has been drawn to the lower right quarter, and `viewport` is that quarter
    for (const { view, x, y } of PANELS) {
      panel.set(viewport.x + (x - 1) * viewport.z, viewport.y + y * viewport.w, viewport.z, viewport.w);
      this.draw(frame, CODES[view] ?? 0, panel);
    }
  }

  /** Fills the G-buffer without the effects' adapters and attachments, in a frame that has effects. */
  fillPlainly(frame: Frame): GBuffer {
    const { adapters, gbufferExtras } = frame;
    frame.adapters = [];
    frame.gbufferExtras = [];
    try {
      return this.fill(frame);
    } finally {
      frame.adapters = adapters;
      frame.gbufferExtras = gbufferExtras;
    }
  }

  dispose(): void {
    this.target.dispose();
    this.surface.dispose();
  }

  private fill(frame: Frame): GBuffer {
    const gbuffer = this.target.begin(frame);
    for (const item of frame.queue.opaque) {
      const twin = viewTwinOf(item);
      if (twin !== null) frame.drawTwin(item, twin);
    }
    return gbuffer;
  }

  private draw(frame: Frame, code: number, viewport: Vector4): void {
    setViewport(frame.webgl, viewport);
    const { uniforms } = this.surface;
    uniforms.farol_view.value = code;
    uniforms.farol_offset.value.set(viewport.x, viewport.y);
    this.surface.draw(frame);
  }
}
