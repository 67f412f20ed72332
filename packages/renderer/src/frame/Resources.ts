import type { Texture, WebGLRenderTarget } from 'three';
import type { GBuffer } from '../gbuffer/GBuffer';
import type { LightBuffer } from './LightBuffer';
import type { ThinGBuffer } from './ThinGBuffer';
import type { FroxelBuffer, MotionBuffer, OcclusionBuffer } from './EffectBuffers';
import type { AccumulatedLight } from './AccumulatedLight';
import type { LightLists } from './LightLists';
import type { RenderItem } from './RenderItem';

/** Textures and buffers that passes share within a frame, by name. */
export interface Resources {
  /** The host's render target, null for the canvas. Given from the start; `Frame.bindTarget` binds it. */
  target: WebGLRenderTarget | null;
  /** Written by the pass that draws to the target a G-buffer's surfaces, or the sums of light on them. Has no value. */
  output: never;
  /** Written by the pass that draws the last opaque items to the target. Has no value. */
  opaque: never;
  /** Number of shadings of each pixel, in red; given from the start in the view 'overdraw', else absent. */
  overdraw: Texture;
  /** Depth of opaque surfaces as the renderer stores it, of the size that the pass draws with. */
  'scene-depth': Texture;
  /** G-buffer of the opaque surfaces. */
  gbuffer: GBuffer;
  /** Direct light at each pixel of the G-buffer (linear radiance); in heat-map views the number of lights, in red. */
  lighting: Texture;
  /** Lists of the lights that may reach each tile or cluster of the picture. */
  'light-lists': LightLists;
  /** Sum of all light on the surfaces that multipass lighting draws. */
  'accumulated-light': AccumulatedLight;
  /** Thin G-buffer of light pre-pass and inferred lighting. */
  'thin-gbuffer': ThinGBuffer;
  /** The light that reaches each texel of the thin G-buffer. */
  'light-buffer': LightBuffer;
  /** Ambient occlusion; written by the effect AmbientOcclusion. */
  occlusion: OcclusionBuffer;
  /** Motion of pixels; written by the effect TAA when the picture is finished. */
  motion: MotionBuffer;
  /** Froxels of fog; written by the effect VolumetricFog before anything is drawn. */
  froxels: FroxelBuffer;
  /** Number of decals on the surfaces of the G-buffer. */
  decals: number;
  /** The transparent items; written by the pass that draws them. */
  transparent: readonly RenderItem[];
  /** Resources of other packages, by a prefixed name such as 'acme:fog'. */
  [own: `${string}:${string}`]: unknown;
}

/** Names of the resources that passes share within a frame. */
export type Resource = keyof Resources;

/** Name of a resource with a value, for `put` and `get`. */
export type HandedResource = Exclude<Resource, 'target' | 'output' | 'opaque'>;

/** Resources given without a pass that writes them. */
export const GIVEN: readonly Resource[] = ['target', 'overdraw'];

/** A pass or an effect, and the resources that it declares. */
export interface ResourceUser {
  readonly name: string;
  readonly reads: readonly Resource[];
  readonly writes: readonly Resource[];
}

interface Entry {
  value: unknown;
  frame: number;
}

/** Error `Technique "x": pass "y" reads "z", which no earlier pass writes.` */
export function nobodyWrites(technique: string, user: string, resource: Resource): Error {
  return new Error(`${place(technique, user)} reads "${resource}", which no earlier pass writes; add one.`);
}

function place(technique: string, user: string): string {
  return `Technique "${technique}": pass "${user}"`;
}

/** The resources of one frame, without allocation from the second frame on. */
export class ResourceTable {
  private readonly entries: Partial<Record<Resource, Entry>> = {};
  private frame = 0;
  private technique = '';
  private user: ResourceUser | null = null;

  /** Begins a frame: no resource is written yet. */
  begin(): void {
    this.frame++;
    this.user = null;
  }

  /** Sets the pass that draws next, whose `reads` and `writes` are enforced; null for effects, which are not checked. */
  use(technique: string, user: ResourceUser | null): void {
    this.technique = technique;
    this.user = user;
  }

  /** Writes a resource for later passes and effects. @throws Error when the pass does not declare it in `writes` */
  put<R extends HandedResource>(name: R, value: Resources[R]): void {
    const { user } = this;
    if (user !== null && !user.writes.includes(name)) throw this.undeclared(user, 'writes', name);
    const entry = this.entries[name];
    if (entry === undefined) this.entries[name] = { value, frame: this.frame };
    else {
      entry.value = value;
      entry.frame = this.frame;
    }
  }

  /**
   * Last value of a resource in this frame.
   * @throws Error when it was not written in this frame, or the pass does not declare it in `reads`
   */
  get<R extends HandedResource>(name: R): Resources[R] {
    const value = this.find(name);
    if (value !== undefined) return value;
    if (this.user !== null) throw nobodyWrites(this.technique, this.user.name, name);
    throw new Error(`Technique "${this.technique}" writes no "${name}", which an effect reads; use another technique.`);
  }

  /**
   * Last value of a resource in this frame; undefined when it was not written.
   * @throws Error when the pass does not declare it in `reads`
   */
  find<R extends HandedResource>(name: R): Resources[R] | undefined {
    const { user } = this;
    if (user !== null && !user.reads.includes(name)) throw this.undeclared(user, 'reads', name);
    const entry = this.entries[name];
    return entry?.frame === this.frame ? (entry.value as Resources[R]) : undefined;
  }

  private undeclared(user: ResourceUser, list: 'reads' | 'writes', name: Resource): Error {
    return new Error(
      `${place(this.technique, user.name)} ${list} "${name}" which is not declared; add it to its ${list}.`,
    );
  }
}
