import {
  CustomBlending,
  HalfFloatType,
  NearestFilter,
  OneFactor,
  OneMinusSrcAlphaFactor,
  Vector4,
  type Texture,
  type WebGLRenderTarget,
} from 'three';
import { lacksFloatTargets } from '../../gpu/checkDevice';
import type { FarolEffect } from '../../frame/FarolEffect';
import { fitTargetTo } from '../../gpu/fitTarget';
import type { Frame } from '../../frame/Frame';
import { WebGLMultipleRenderTargets } from '../../three/WebGLMultipleRenderTargets';
import type { TwinKind } from '../../materials/TwinKind';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import { targetBytes } from '../../gpu/targetBytes';
import type { Pass } from '../../frame/Pass';
import { Picture } from '../Picture';
import { isWeighted, weightedTwin } from './weightedTwin';
import weightedResolve from './weightedResolve.glsl?raw';
import { isDrawnAsCanvas, setDrawnAsCanvas } from '../../three/drawnAsCanvas';

const CLEAR = new Vector4(0, 0, 0, 1);

/**
 * Weighted blended order-independent transparency: transparent objects need no sorting, may intersect, and never pop as their
 * order changes. All layers of a pixel are averaged, weighted by opacity and nearness; their total opacity is exact. One layer
 * looks as if sorted; several are an approximation. Materials with another blending than NormalBlending, without depth test, or
 * with shaders that write their own outputs are drawn afterwards, sorted. Layers write no depth. Works with every technique
 * except `inferred`, whose stippled layers are sorted.
 * @see McGuire and Bavoil 2013, Weighted Blended Order-Independent Transparency, https://jcgt.org/published/0002/02/09/
 */
export class WeightedBlendedOIT implements FarolEffect {
  readonly name = 'order-independent transparency';
  readonly lacks = lacksFloatTargets;
  readonly takesPicture = true;
  readonly replaces = 'transparent';
  private target: WebGLMultipleRenderTargets | null = null;
  private underTarget: WebGLRenderTarget | null = null;
  private shared: Picture | null = null;
  private readonly twins = new Map<TwinKind, TwinKind>();
  /** True while transparent items are added to the weighted sums. */
  private isWeighing = false;
  private readonly resolve = new FullscreenPass({
    program: 'weighted transparency',
    fragment: 'weightedResolve',
    microShaders: { weightedResolve },
    uniforms: {
      farol_layers: { value: null as Texture | null },
      farol_weights: { value: null as Texture | null },
    },
    blending: CustomBlending,
    blendSrc: OneFactor,
    blendDst: OneMinusSrcAlphaFactor,
  });

  get bytes(): number {
    return (this.target === null ? 0 : targetBytes(this.target, false)) + (this.shared?.bytes ?? 0);
  }

  begin(frame: Frame): void {
    this.isWeighing = false; // resets the state that an exception in the last frame may have left
    this.shared = Picture.of(frame);
    this.shared.begin(frame);
  }

  render(frame: Frame, pass: Pass): void {
    const { transparent } = frame.queue;
    let weighted = 0;
    for (const item of transparent) {
      item.drawn = !isWeighted(item);
      if (!item.drawn) weighted++;
    }
    if (weighted > 0) {
      this.drawLayers(frame, pass);
      for (const item of transparent) item.drawn = !item.drawn;
    }
    if (weighted < transparent.length) {
      if (weighted === 0) for (const item of transparent) item.drawn = false;
      pass.render(frame);
    }
  }

  end(frame: Frame): void {
    this.shared!.end(frame);
  }

  dispose(): void {
    this.target?.dispose();
    this.target = this.underTarget = null;
    this.resolve.dispose();
    this.shared?.dispose();
  }

  /** Draws the weighted sums, hidden by the picture's depth, then blends them over the picture. */
  private drawLayers(frame: Frame, pass: Pass): void {
    const picture = this.shared!.target;
    const target = this.prepareTarget(picture);
    frame.target = target;
    this.isWeighing = true;
    frame.bindTarget();
    frame.clear(2, false, CLEAR);
    pass.render(frame);
    frame.target = picture;
    this.isWeighing = false;
    this.resolve.uniforms.farol_layers.value = target.textures[0];
    this.resolve.uniforms.farol_weights.value = target.textures[1];
    frame.bindTarget();
    this.resolve.draw(frame);
  }

  adapt(kind: TwinKind): TwinKind {
    if (!this.isWeighing) return kind;
    let twin = this.twins.get(kind);
    if (twin === undefined) this.twins.set(kind, (twin = weightedTwin(kind)));
    return twin;
  }

  private prepareTarget(picture: WebGLRenderTarget): WebGLMultipleRenderTargets {
    const { width, height } = picture;
    if (this.underTarget !== picture) this.target?.dispose();
    if (this.target === null || this.underTarget !== picture) {
      this.underTarget = picture;
      this.target = new WebGLMultipleRenderTargets(width, height, 2, {
        type: HalfFloatType,
        minFilter: NearestFilter,
        magFilter: NearestFilter,
        colorSpace: picture.texture.colorSpace as '',
        stencilBuffer: picture.stencilBuffer,
        depthTexture: picture.depthTexture!,
      });
      setDrawnAsCanvas(this.target, isDrawnAsCanvas(picture));
    }
    fitTargetTo(this.target, picture);
    return this.target;
  }
}
