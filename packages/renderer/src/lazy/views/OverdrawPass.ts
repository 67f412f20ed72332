import { HalfFloatType, NearestFilter, Vector2, WebGLRenderTarget, type IUniform, type Texture } from 'three';
import type { Frame } from '../../frame/Frame';
import { depthTwin, hasDepthTwin } from '../../forward/depthTwin';
import { canCountOverdraw, overdrawTwin } from '../../materials/overdrawTwin';
import type { RenderItem } from '../../frame/RenderItem';
import { FullscreenMesh } from '../../gpu/FullscreenMesh';
import { OutputMaterial } from '../../gpu/PassMaterial';

/** Counts how often a material is shaded at each pixel, in the order in which the technique draws. For the view 'overdraw'. */
export class OverdrawPass {
  readonly name = 'overdraw';
  target: WebGLRenderTarget | null = null;
  private readonly map: IUniform<Texture | null> = { value: null };
  private readonly offset = { value: new Vector2() };
  private readonly triangle = new FullscreenMesh();
  private material: OutputMaterial | null = null;

  get bytes(): number {
    return this.target ? this.target.width * this.target.height * 12 : 0;
  }

  /** @param depthFirst the technique draws depth before it shades */
  render(frame: Frame, depthFirst: boolean): void {
    const { width, height } = frame;
    this.target ??= new WebGLRenderTarget(1, 1, {
      type: HalfFloatType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
    });
    if (this.target.width !== width || this.target.height !== height) this.target.setSize(width, height);
    frame.bind(this.target);
    frame.clear(1, true);
    if (depthFirst) {
      for (const item of frame.queue.opaque) {
        if (item.splits && hasDepthTwin(item.material)) frame.drawTwin(item, depthTwin);
      }
    }
    this.count(frame, frame.queue.opaque);
    this.count(frame, frame.queue.transmissive);
    this.count(frame, frame.queue.transparent);
    frame.overdraw = this.target.texture;
  }

  /** Shows the counts alone, for techniques that have no output pass. */
  show(frame: Frame): void {
    this.map.value = frame.overdraw;
    this.offset.value.set(frame.viewport.x, frame.viewport.y);
    this.material ??= new OutputMaterial(frame.microshaders, {
      name: 'Farol count view',
      vertex: ['fullscreen'],
      fragment: ['countView'],
      uniforms: { ...frame.uniforms, farol_overdrawMap: this.map, farol_offset: this.offset },
    });
    frame.bindTarget();
    frame.drawMesh(this.triangle, this.material);
  }

  dispose(): void {
    this.target?.dispose();
    this.material?.dispose();
    this.target = this.material = null;
  }

  private count(frame: Frame, items: readonly RenderItem[]): void {
    for (const item of items) if (canCountOverdraw(item.material)) frame.drawTwin(item, overdrawTwin);
  }
}
