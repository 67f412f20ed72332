import {
  HalfFloatType,
  RedFormat,
  RGBAFormat,
  RGFormat,
  type IUniform,
  type Texture,
  Vector2,
  Vector4,
  type WebGLRenderTarget,
} from 'three';
import { lacksFloatTargets } from '../../gpu/checkDevice';
import type { OcclusionBuffer } from '../../frame/EffectBuffers';
import type { FarolEffect } from '../../frame/FarolEffect';
import type { Frame } from '../../frame/Frame';
import { Lazy } from '../../frame/Lazy';
import { hasDepthTwin } from '../../materials/depthTwin';
import type { GBuffer } from '../../gbuffer/GBuffer';
import type { GBufferAttachment } from '../../gbuffer/gbufferLayout';
import type { TwinKind } from '../../materials/TwinKind';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import { setUnprojectUniforms, unprojectUniforms } from '../../gpu/unprojectUniforms';
import { isPlain, type RenderItem } from '../../frame/RenderItem';
import { storedKind } from '../../passes/gbuffer/gbufferUniforms';
import ambientOcclusion from './ambientOcclusion.glsl?raw';
import { DistancePass } from '../../passes/forward/DistancePass';
import occlusionFilter from './occlusionFilter.glsl?raw';
import occlusionSurface from './occlusionSurface.glsl?raw';
import { indirectTwin, occludedTwin } from './occlusionTwins';

const SIZE = ['farol_frameSize'];
/** Greatest radius on screen (pixels at full resolution); samples would be too sparse in a larger one. */
const LARGEST_RADIUS = 256;

/** Attachment for the light that occlusion darkens: ambient, environment, light maps, reflections by roughness. */
const INDIRECT: GBufferAttachment = { name: 'indirect', format: RGBAFormat, type: HalfFloatType, bytes: 8 };

/** Destination of a frame's occlusion: the G-buffer's accumulation, or the materials drawn after the occlusion. */
type Use = 'none' | 'accumulation' | 'prepass' | 'light-buffer';

/**
 * Ambient occlusion (GTAO): finds from depth and normals how much of the sky nearby surfaces hide from each pixel, and darkens
 * ambient, hemisphere, environment and light map light by it; direct and emissive light do not change. Rougher environment
 * reflections are darkened more.
 *
 * With `deferred`, `tiled-deferred` and `clustered-deferred` it reads the G-buffer, which then has a fifth attachment
 * for indirect light (materials that it cannot hold are not darkened); with `light-prepass` the thin G-buffer; with
 * `forward-plus` its depth, from which normals are rebuilt. Other techniques have no depth before they shade: there,
 * and with a G-buffer on devices that draw to only four buffers at once, it is left out with a warning.
 * @see Jimenez, Wu, Pesce and Jarabo 2016, Practical Real-Time Strategies for Accurate Indirect Occlusion
 */
export class AmbientOcclusion implements FarolEffect, OcclusionBuffer {
  readonly name = 'ambient occlusion';
  readonly after = ['gbuffer', 'scene-depth'] as const;
  readonly needsSurfaces = true;
  readonly attachments = [INDIRECT];
  readonly lacks = lacksFloatTargets;
  /** Distance within which surfaces occlude (m), above 0. Default 0.5. */
  radius = 0.5;
  /** Exponent of the open share of the sky: 0 for no occlusion, 1 for the computed occlusion. Default 1. */
  strength = 1;
  /** Whether to compute occlusion at half the resolution, upsampled by a filter that keeps edges. Default false. */
  halfResolution = false;
  private use: Use = 'none';
  private warned = false;
  /** Location of the attachment of indirect light; -1 if the device has no room for it. */
  private location = -1;
  /** Whether the frame's G-buffer lacks the attachment of indirect light. */
  private unfit = false;
  private readonly surface = {
    ...unprojectUniforms(),
    farol_reach: { value: new Vector4() },
    farol_surfaceDepth: { value: null as Texture | null },
    farol_surfaceNormal: { value: null as Texture | null },
    farol_surfaceDistance: { value: null as Texture | null },
    farol_surfaceStored: { value: [0, 0] },
  };
  private readonly filtering = {
    ...this.surface,
    farol_openMap: { value: null as Texture | null },
    farol_strength: { value: 1 },
    farol_lit: { value: null as Texture | null },
    farol_indirect: { value: null as Texture | null },
  };
  private readonly openByNormals = this.openPass({ FAROL_NORMALS: '' });
  private readonly openByDepth = this.openPass({});
  private readonly share = new FullscreenPass({
    program: 'occlusionFilter',
    fragment: 'occlusionFilter',
    shared: SIZE,
    microShaders: { occlusionSurface, occlusionFilter },
    uniforms: this.filtering,
    target: { format: RedFormat },
  });
  private readonly accumulation = new FullscreenPass({
    program: 'occlusionFilter',
    fragment: 'occlusionFilter',
    shared: SIZE,
    microShaders: { occlusionSurface, occlusionFilter },
    uniforms: this.filtering,
    defines: { FAROL_ACCUMULATION: '' },
    target: { type: HalfFloatType },
  });
  private readonly occlusion = {
    farol_occlusionMap: { value: null as Texture | null },
    farol_occlusionOffset: { value: new Vector2() },
  };
  private readonly distances = new DistancePass(({ route, material }) => route === 'split' && hasDepthTwin(material));
  private readonly twins = new Map<TwinKind, TwinKind>();

  get bytes(): number {
    return this.passes.reduce((sum, { bytes }) => sum + bytes, this.distances.bytes);
  }

  begin(frame: Frame): void {
    this.use = 'none';
    this.unfit = false;
    const location = frame.locationOf(INDIRECT);
    if (location !== this.location) this.twins.clear();
    this.location = location;
  }

  render(frame: Frame): void {
    const { resources } = frame;
    const gbuffer = resources.find('gbuffer');
    const thin = resources.find('thin-gbuffer');
    if (gbuffer !== undefined) this.occludeGBuffer(frame, gbuffer);
    else if (thin === undefined) {
      this.use = 'prepass';
      this.setDistances(frame, frame.storesDistance ? this.distances.render(frame).texture : null);
      this.draw(frame, this.share, resources.get('scene-depth'), null);
    } else if (thin.scale === 1) {
      this.use = 'light-buffer';
      this.setDistances(frame, thin.target.textures[1] ?? null);
      this.draw(frame, this.share, resources.get('scene-depth'), thin.target.texture);
    }
  }

  end(): void {
    // does not warn while a technique's code is loading, since a stand-in technique draws these frames
    if (this.use !== 'none' || this.warned || Lazy.lacking!.size > 0) return;
    this.warned = true;
    console.warn(
      this.unfit
        ? "Farol: ambient occlusion is left out, since it needs a fifth texture in the G-buffer and this device draws to four at once; use 'light-prepass' or 'forward-plus'."
        : "Farol: ambient occlusion is left out, since the technique in use has no depth before it lights; use 'deferred', 'tiled-deferred', 'clustered-deferred', 'light-prepass' or 'forward-plus'.",
    );
  }

  dispose(): void {
    for (const pass of this.passes) pass.dispose();
    this.distances.dispose();
  }

  adapt(kind: TwinKind, item: RenderItem): TwinKind {
    const { role } = kind;
    if (role === 'gbuffer') return this.location < 0 ? kind : this.twinOf(kind);
    if (!isPlain(item) || role === undefined) return kind;
    const occluded =
      (this.use === 'prepass' && hasDepthTwin(item.material)) ||
      (this.use === 'light-buffer' && role === 'light-buffer');
    return occluded ? this.twinOf(kind) : kind;
  }

  private get passes(): readonly FullscreenPass[] {
    return [this.openByNormals, this.openByDepth, this.share, this.accumulation];
  }

  private twinOf(kind: TwinKind): TwinKind {
    let twin = this.twins.get(kind);
    if (twin === undefined) {
      twin = kind.role === 'gbuffer' ? indirectTwin(kind, this.location) : occludedTwin(kind, this.occlusion);
      this.twins.set(kind, twin);
    }
    return twin;
  }

  private occludeGBuffer(frame: Frame, gbuffer: GBuffer): void {
    this.unfit = this.location < 0;
    if (this.unfit) return;
    this.use = 'accumulation';
    this.filtering.farol_lit.value = gbuffer.accumulation;
    this.filtering.farol_indirect.value = gbuffer.target.textures[this.location];
    this.setDistances(frame, gbuffer.storesDistance ? gbuffer.normal : null, 2);
    const { texture } = this.draw(frame, this.accumulation, gbuffer.depth, gbuffer.normal);
    gbuffer.accumulation = texture;
  }

  /**
   * Sets the source of the surfaces' distances.
   * @param distances - texture of distances packed by storedDistance.glsl; null to use depth
   * @param component - first component of the distance in a texel
   */
  private setDistances(frame: Frame, distances: Texture | null, component = 0): void {
    const { farol_surfaceDistance, farol_surfaceStored } = this.surface;
    farol_surfaceDistance.value = distances;
    farol_surfaceStored.value[0] = distances === null ? 0 : storedKind(frame.camera);
    farol_surfaceStored.value[1] = component;
  }

  /** Computes the open share of the sky over each pixel, and filters it into the target of a pass. */
  private draw(
    frame: Frame,
    filter: AmbientOcclusion['share'],
    depth: Texture,
    normal: Texture | null,
  ): WebGLRenderTarget {
    const { width, height } = frame;
    const { filtering } = this;
    const step = this.halfResolution ? 2 : 1;
    const pixels = this.radius * frame.camera.projectionMatrix.elements[5] * 0.5 * height;
    filtering.farol_reach.value.set(this.radius, pixels, step, LARGEST_RADIUS);
    filtering.farol_strength.value = this.strength;
    filtering.farol_surfaceDepth.value = depth;
    filtering.farol_surfaceNormal.value = normal;
    setUnprojectUniforms(filtering, frame.camera, frame.webgl);
    const open = normal === null ? this.openByDepth : this.openByNormals;
    const sky = open.drawToOwn(frame, Math.ceil(width / step), Math.ceil(height / step));
    filtering.farol_openMap.value = sky.texture;
    const result = filter.drawToOwn(frame, width, height);
    this.occlusion.farol_occlusionMap.value = result.texture;
    this.occlusion.farol_occlusionOffset.value.set(frame.viewport.x, frame.viewport.y);
    frame.resources.put('occlusion', this);
    return result;
  }

  /** Open share of the sky in the last frame; this call draws it if that frame only darkened light in the G-buffer. */
  openSky(frame: Frame): Texture {
    const { share, use } = this;
    return (use === 'accumulation' ? share.drawToOwn(frame, frame.width, frame.height) : share).texture as Texture;
  }

  private openPass(defines: Record<string, string>): FullscreenPass {
    return new FullscreenPass({
      program: 'ambientOcclusion',
      fragment: 'ambientOcclusion',
      shared: SIZE,
      microShaders: { occlusionSurface, ambientOcclusion },
      uniforms: this.surface as Record<string, IUniform>,
      defines,
      target: { format: RGFormat, type: HalfFloatType },
    });
  }
}
