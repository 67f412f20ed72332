import { Matrix4, Vector3, Vector4, type OrthographicCamera, type PerspectiveCamera } from 'three';
import type { View } from '../../frame/views';
import type { Frame } from '../../frame/Frame';
import { FullscreenMesh } from '../../gpu/FullscreenMesh';
import { GBufferPass } from '../../gbuffer/GBufferPass';
import { gbufferUniforms, setGBufferUniforms } from '../../gbuffer/gbufferUniforms';
import { litViewTwin, unlitViewTwin } from './gbufferViewTwins';
import { OutputMaterial } from '../../gpu/PassMaterial';

/** `farol_view` of surfaceView.glsl. */
const CODES: Partial<Record<View, number>> = {
  albedo: 0,
  normal: 1,
  depth: 2,
  position: 3,
  roughness: 4,
  metalness: 5,
  emissive: 6,
};

/** Where 'grid' puts its panels, in halves of the viewport; the final picture is at the lower right (thesis 4.1). */
const PANELS = [
  { view: 'albedo', x: 0, y: 1 },
  { view: 'normal', x: 1, y: 1 },
  { view: 'depth', x: 0, y: 0 },
] as const;

const panel = new Vector4();

/** Fills a G-buffer with every mesh, whatever the technique, and shows one of its things, or three of them round the picture. */
export class SurfaceViewPass {
  readonly name = 'view';
  private readonly gbuffer = new GBufferPass({ lit: litViewTwin, unlit: unlitViewTwin });
  private readonly uniforms = gbufferUniforms();
  private readonly view = { value: 0 };
  private readonly depthRange = { value: new Vector3() };
  private readonly viewInverse = { value: new Matrix4() };
  private readonly triangle = new FullscreenMesh();
  private material: OutputMaterial | null = null;

  get bytes(): number {
    return this.gbuffer.bytes;
  }

  /** Shows `frame.view` over the viewport, or its panels for 'grid'. */
  render(frame: Frame): void {
    this.gbuffer.render(frame);
    setGBufferUniforms(this.uniforms, this.gbuffer.gbuffer!, frame);
    const camera = frame.camera as PerspectiveCamera & OrthographicCamera;
    const { near, far } = camera;
    const logarithmic = camera.isPerspectiveCamera && near > 0 && Number.isFinite(far);
    this.depthRange.value.set(near, Number.isFinite(far) ? far : near + 1000, logarithmic ? 1 : 0);
    this.viewInverse.value.copy(camera.matrixWorld);
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

  dispose(): void {
    this.gbuffer.dispose();
    this.material?.dispose();
    this.material = null;
  }

  private draw(frame: Frame, code: number, viewport: Vector4): void {
    frame.webgl.state.viewport(viewport);
    this.material ??= new OutputMaterial(frame.microshaders, {
      name: 'Farol surface view',
      vertex: ['fullscreen'],
      fragment: ['surfaceView'],
      uniforms: {
        ...frame.uniforms,
        ...this.uniforms,
        farol_view: this.view,
        farol_depthRange: this.depthRange,
        farol_viewInverse: this.viewInverse,
      },
    });
    this.view.value = code;
    this.uniforms.farol_offset.value.set(viewport.x, viewport.y);
    this.material.uniformsNeedUpdate = true;
    frame.drawMesh(this.triangle, this.material);
  }
}
