import {
  HalfFloatType,
  NearestFilter,
  RedFormat,
  RGFormat,
  type IUniform,
  type Texture,
  Vector2,
  Vector4,
} from 'three';
import { drawBuffersOf, lacksFloatTargets } from '../../gpu/checkDevice';
import type { FarolEffect } from '../../frame/FarolEffect';
import type { Frame } from '../../frame/Frame';
import { hasDepthTwin } from '../../forward/depthTwin';
import { gbufferTwin } from '../../gbuffer/gbufferTwins';
import type { TwinKind } from '../../materials/TwinKind';
import { DepthPrepass } from '../../forward/DepthPrepass';
import { FullscreenMesh } from '../../gpu/FullscreenMesh';
import { GBufferPass } from '../../gbuffer/GBufferPass';
import type { Pass } from '../../frame/Pass';
import { PassMaterial } from '../../gpu/PassMaterial';
import { ThinGBufferPass } from '../../lazy/light-buffer/ThinGBufferPass';
import { setUnprojectUniforms, unprojectUniforms } from '../../gpu/unprojectUniforms';
import type { RenderItem } from '../../frame/RenderItem';
import { addMicroShaders } from '../../microshaders/addMicroShaders';
import { EffectTarget } from '../EffectTarget';
import ambientOcclusion from './ambientOcclusion.glsl?raw';
import occlusionFilter from './occlusionFilter.glsl?raw';
import { INDIRECT, layoutWithIndirect } from './layoutWithIndirect';
import { indirectTwin, occludedTwin } from './occlusionTwins';

/** Radius on the picture beyond which samples would lie too far apart (pixels at full resolution). */
const LARGEST_RADIUS = 256;

/** Where the occlusion of a frame goes: into the accumulation of the G-buffer, or to materials that are drawn after it. */
type Use = 'none' | 'accumulation' | 'prepass' | 'light-buffer';

interface Materials {
  readonly open: PassMaterial;
  readonly filter: PassMaterial;
}

/**
 * Ambient occlusion (GTAO): how much of the sky over each pixel is closed by what lies near it, from depth and normals, takes
 * down ambient, hemisphere, environment and light map light; direct and emissive light stay as they are. Of environment
 * reflections the rougher ones are taken down more.
 *
 * With `deferred`, `tiled-deferred` and `clustered-deferred` it reads the G-buffer, which then has a fifth attachment for
 * indirect light (materials that the G-buffer cannot hold get none); with `light-prepass` the thin G-buffer; with
 * `forward-plus` its depth, from which normals are rebuilt. Other techniques know no depth before they shade: there it is
 * left out, and a warning says so; as it is with a G-buffer on devices that draw to four buffers at once.
 * @see Jimenez, Wu, Pesce and Jarabo 2016, Practical Real-Time Strategies for Accurate Indirect Occlusion
 */
export class AmbientOcclusion implements FarolEffect {
  readonly name = 'ambient occlusion';
  readonly after = ['gbuffer', 'scene-depth'] as const;
  readonly needsSurfaces = true;
  readonly lacks = lacksFloatTargets;
  /** How far off things close the sky (m), above 0. Default 0.5. */
  radius = 0.5;
  /** Power of the open share; 0 is none, 1 as it is. Default 1. */
  strength = 1;
  /** Computes it at half the resolution, and brings it up by a filter that keeps to edges. Default false. */
  halfResolution = false;
  private use: Use = 'none';
  private warned = false;
  /** Whether the device draws to as many buffers as the G-buffer with indirect light has; asked in the first frame. */
  private fits: boolean | null = null;
  /** Whether the frame has a G-buffer that does not fit. */
  private unfit = false;
  private readonly open = new EffectTarget(
    { format: RGFormat, type: HalfFloatType, minFilter: NearestFilter, magFilter: NearestFilter },
    4,
  );
  private readonly filtered = new EffectTarget(
    { format: RedFormat, minFilter: NearestFilter, magFilter: NearestFilter },
    1,
  );
  private readonly accumulation = new EffectTarget(
    { type: HalfFloatType, minFilter: NearestFilter, magFilter: NearestFilter },
    8,
  );
  private readonly unproject = unprojectUniforms();
  private readonly reach = { value: new Vector4() };
  private readonly power = { value: 1 };
  private readonly depth: IUniform<Texture | null> = { value: null };
  private readonly normal: IUniform<Texture | null> = { value: null };
  private readonly openMap: IUniform<Texture | null> = { value: null };
  private readonly lit: IUniform<Texture | null> = { value: null };
  private readonly indirect: IUniform<Texture | null> = { value: null };
  private readonly occlusion = {
    farol_occlusionMap: { value: null as Texture | null },
    farol_occlusionOffset: { value: new Vector2() },
  };
  private readonly triangle = new FullscreenMesh();
  private readonly made = new Map<string, Materials>();
  private readonly twins = new Map<TwinKind, TwinKind>();

  get bytes(): number {
    return this.open.bytes + this.filtered.bytes + this.accumulation.bytes;
  }

  begin(frame: Frame): void {
    this.use = 'none';
    this.fits ??= drawBuffersOf(frame.gl) >= layoutWithIndirect.length;
    this.unfit = false;
    if (this.fits) frame.gbufferLayout = layoutWithIndirect;
    frame.adapt = this.adapt;
  }

  render(frame: Frame, pass: Pass): void {
    if (pass instanceof GBufferPass) {
      this.unfit = !this.fits;
      if (this.unfit) return;
      const gbuffer = pass.gbuffer!;
      this.use = 'accumulation';
      this.lit.value = gbuffer.accumulation;
      this.indirect.value = gbuffer.target.textures[INDIRECT];
      this.draw(frame, gbuffer.depth, gbuffer.normal);
    } else if (pass instanceof DepthPrepass) {
      this.use = 'prepass';
      this.draw(frame, pass.target!.depthTexture!, null);
    } else if (pass instanceof ThinGBufferPass && pass.scale.value === 1) {
      this.use = 'light-buffer';
      this.draw(frame, pass.target!.depthTexture!, pass.target!.texture);
    }
  }

  end(): void {
    if (this.use !== 'none' || this.warned) return;
    this.warned = true;
    console.warn(
      this.unfit
        ? "Farol: ambient occlusion is left out, since its G-buffer has five attachments and this device draws to four at once; use 'light-prepass' or 'forward-plus'."
        : "Farol: ambient occlusion is left out, since the technique in use knows no depth before it shades; use 'deferred', 'tiled-deferred', 'clustered-deferred', 'light-prepass' or 'forward-plus'.",
    );
  }

  dispose(): void {
    for (const target of [this.open, this.filtered, this.accumulation]) target.dispose();
    for (const { open, filter } of this.made.values()) {
      open.dispose();
      filter.dispose();
    }
    this.made.clear();
  }

  private readonly adapt = (kind: TwinKind, item: RenderItem): TwinKind => {
    if (kind === gbufferTwin) return this.fits ? this.twinOf(kind) : kind;
    if (!item.plain || !kind.key.startsWith('forward-')) return kind;
    const occluded =
      (this.use === 'prepass' && hasDepthTwin(item.material)) ||
      (this.use === 'light-buffer' && kind.key.startsWith('forward-lightLoopBuffer'));
    return occluded ? this.twinOf(kind) : kind;
  };

  private twinOf(kind: TwinKind): TwinKind {
    let twin = this.twins.get(kind);
    if (twin === undefined) {
      twin = kind === gbufferTwin ? indirectTwin(kind) : occludedTwin(kind, this.occlusion);
      this.twins.set(kind, twin);
    }
    return twin;
  }

  private draw(frame: Frame, depth: Texture, normal: Texture | null): void {
    const { width, height } = frame;
    const step = this.halfResolution ? 2 : 1;
    const { open, filter } = this.materials(frame, normal !== null, this.use === 'accumulation');
    const openTarget = this.open.of(Math.ceil(width / step), Math.ceil(height / step));
    const pixels = this.radius * frame.camera.projectionMatrix.elements[5] * 0.5 * height;
    this.reach.value.set(this.radius, pixels, step, LARGEST_RADIUS);
    this.power.value = this.strength;
    this.depth.value = depth;
    this.normal.value = normal;
    this.openMap.value = openTarget.texture;
    setUnprojectUniforms(this.unproject, frame.camera, frame.webgl);
    frame.bind(openTarget);
    frame.drawMesh(this.triangle, open);
    const result = (this.use === 'accumulation' ? this.accumulation : this.filtered).of(width, height);
    frame.bind(result);
    frame.drawMesh(this.triangle, filter);
    if (this.use === 'accumulation') frame.accumulation = result.texture;
    this.occlusion.farol_occlusionMap.value = result.texture;
    this.occlusion.farol_occlusionOffset.value.set(frame.viewport.x, frame.viewport.y);
  }

  private materials(frame: Frame, normals: boolean, accumulation: boolean): Materials {
    const key = `${normals} ${accumulation}`;
    let materials = this.made.get(key);
    if (materials === undefined) {
      addMicroShaders(frame.microshaders, 'AmbientOcclusion', { ambientOcclusion, occlusionFilter });
      const uniforms = { ...this.unproject, farol_reach: this.reach, farol_surfaceDepth: this.depth };
      const material = (chunk: string, define: string, defined: boolean, more: Record<string, IUniform>) =>
        new PassMaterial(frame.microshaders, {
          name: `Farol ${chunk}`,
          vertex: ['fullscreen'],
          fragment: [chunk],
          uniforms: { ...uniforms, ...more },
          defines: defined ? { [define]: '' } : {},
        });
      materials = {
        open: material('ambientOcclusion', 'FAROL_NORMALS', normals, { farol_surfaceNormal: this.normal }),
        filter: material('occlusionFilter', 'FAROL_ACCUMULATION', accumulation, {
          farol_openMap: this.openMap,
          farol_strength: this.power,
          farol_lit: this.lit,
          farol_indirect: this.indirect,
        }),
      };
      this.made.set(key, materials);
    }
    return materials;
  }
}
