import { Vector2, type IUniform, type Texture } from 'three';
import type { Frame } from '../../frame/Frame';
import type { ForwardTwins } from '../../forward/forwardTwin';
import { lightBufferTwins } from './lightBufferTwins';
import { resetObject, setObject } from './objectAttribute';
import type { View } from '../../frame/views';
import { FullscreenMesh } from '../../gpu/FullscreenMesh';
import type { LightBufferPass } from './LightBufferPass';
import { lightBufferUniforms, setLightBufferUniforms } from './lightBufferUniforms';
import { objectNumber } from './objectNumbers';
import type { Pass } from '../../frame/Pass';
import { OutputMaterial } from '../../gpu/PassMaterial';
import type { ThinGBufferPass } from './ThinGBufferPass';

/**
 * Draws the surfaces of the thin G-buffer once more, into the host's target and with its depth, each by its own material,
 * which takes its direct light from the light buffer.
 * @see Engel 2009, The Light Pre-Pass Renderer; Kircher and Lawrance 2009, Inferred Lighting; thesis 2.2.3.3.2
 */
export class LitMaterialsPass implements Pass {
  readonly name = 'output';
  readonly reads = ['thin-gbuffer', 'scene-depth', 'light-buffer'] as const;
  readonly writes = ['target'] as const;
  readonly bytes = 0;
  /** Lit materials by the light buffer of this frame; set `farol_object` for each draw. */
  readonly twins: (view: View) => ForwardTwins;
  private readonly uniforms = lightBufferUniforms();
  private readonly overdraw: IUniform<Texture | null> = { value: null };
  private readonly offset = { value: new Vector2() };
  private readonly triangle = new FullscreenMesh();
  private counts: OutputMaterial | null = null;

  constructor(
    private readonly surfaces: ThinGBufferPass,
    private readonly lights: LightBufferPass,
  ) {
    this.twins = lightBufferTwins(this.uniforms);
  }

  render(frame: Frame): void {
    setLightBufferUniforms(this.uniforms, this.surfaces, this.lights, frame);
    frame.bindTarget();
    if (frame.view === 'overdraw') {
      this.showCounts(frame);
      return;
    }
    const twins = this.twins(frame.view);
    const { items } = this.surfaces;
    try {
      for (let i = 0; i < items.length; i++) {
        setObject(frame.gl, objectNumber(i), 0);
        frame.drawTwin(items[i], twins.whole);
        items[i].drawn = true;
      }
    } finally {
      resetObject(frame.gl);
    }
  }

  dispose(): void {
    this.counts?.dispose();
    this.counts = null;
  }

  private showCounts(frame: Frame): void {
    this.overdraw.value = frame.overdraw;
    this.offset.value.set(frame.viewport.x, frame.viewport.y);
    this.counts ??= new OutputMaterial(frame.microshaders, {
      name: 'Farol light buffer counts',
      vertex: ['fullscreen'],
      fragment: ['lightBufferCounts'],
      uniforms: { ...frame.uniforms, ...this.uniforms, farol_overdrawMap: this.overdraw, farol_offset: this.offset },
    });
    frame.drawMesh(this.triangle, this.counts);
  }
}
