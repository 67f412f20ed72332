import {
  CustomBlending,
  HalfFloatType,
  NearestFilter,
  OneFactor,
  OneMinusSrcAlphaFactor,
  Vector4,
  type IUniform,
  type Texture,
  type WebGLRenderTarget,
} from 'three';
import { lacksFloatTargets } from '../../gpu/checkDevice';
import type { FarolEffect } from '../../frame/FarolEffect';
import type { Frame } from '../../frame/Frame';
import { WebGLMultipleRenderTargets } from '../../three/WebGLMultipleRenderTargets';
import type { TwinKind } from '../../materials/TwinKind';
import { ForwardPass } from '../../forward/ForwardPass';
import { FullscreenMesh } from '../../gpu/FullscreenMesh';
import type { Pass } from '../../frame/Pass';
import { PassMaterial } from '../../gpu/PassMaterial';
import { addMicroShaders } from '../../microshaders/addMicroShaders';
import { Picture } from '../Picture';
import { isWeighted, weightedTwin } from './weightedTwin';
import weightedResolve from './weightedResolve.glsl?raw';

const CLEAR = new Vector4(0, 0, 0, 1);

/**
 * Weighted blended order-independent transparency: transparent things need no sorting, may pass through one another, and
 * never pop as their order changes. All layers of a pixel are averaged, weighted by opacity and nearness; how much they hide
 * of what is behind is exact. One layer looks as it does when sorted; several of them are an approximation. Materials
 * with other blending than normal, without depth test, or with shaders that write outputs of their own are laid over
 * afterwards, sorted as ever. Layers write no depth.
 *
 * Works with every technique but `inferred`, whose stippled layers stay sorted.
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
  private readonly layers: IUniform<Texture | null> = { value: null };
  private readonly weights: IUniform<Texture | null> = { value: null };
  private readonly triangle = new FullscreenMesh();
  private material: PassMaterial | null = null;

  get bytes(): number {
    return (this.target ? this.target.width * this.target.height * 16 : 0) + (this.shared?.bytes ?? 0);
  }

  begin(frame: Frame): void {
    this.shared = Picture.of(frame);
    this.shared.begin(frame);
  }

  render(frame: Frame, pass: Pass): void {
    const { transparent } = frame.queue;
    let weighted = 0;
    if (pass instanceof ForwardPass) {
      for (const item of transparent) {
        item.drawn = !isWeighted(item);
        if (!item.drawn) weighted++;
      }
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
    this.material?.dispose();
    this.material = null;
    this.shared?.dispose();
  }

  /** The weighted sums, under the picture's depth, then over the picture. */
  private drawLayers(frame: Frame, pass: Pass): void {
    const picture = this.shared!.target;
    const { adapt } = frame;
    const target = this.prepareTarget(picture);
    frame.target = target;
    frame.adapt = this.adapt;
    frame.bindTarget();
    frame.clear(2, false, CLEAR);
    pass.render(frame);
    frame.target = picture;
    frame.adapt = adapt;
    this.layers.value = target.textures[0];
    this.weights.value = target.textures[1];
    this.material ??= this.makeMaterial(frame);
    frame.bindTarget();
    frame.drawMesh(this.triangle, this.material);
  }

  private readonly adapt = (kind: TwinKind): TwinKind => {
    let twin = this.twins.get(kind);
    if (twin === undefined) this.twins.set(kind, (twin = weightedTwin(kind)));
    return twin;
  };

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
      // drawn to as the picture is
      Object.assign(this.target, {
        isXRRenderTarget: (picture as { isXRRenderTarget?: boolean }).isXRRenderTarget ?? false,
      });
    }
    if (this.target.width !== width || this.target.height !== height) this.target.setSize(width, height);
    return this.target;
  }

  private makeMaterial(frame: Frame): PassMaterial {
    addMicroShaders(frame.microshaders, 'WeightedBlendedOIT', { weightedResolve });
    return new PassMaterial(frame.microshaders, {
      name: 'Farol weighted transparency',
      vertex: ['fullscreen'],
      fragment: ['weightedResolve'],
      uniforms: { farol_layers: this.layers, farol_weights: this.weights },
      blending: CustomBlending,
      blendSrc: OneFactor,
      blendDst: OneMinusSrcAlphaFactor,
    });
  }
}
