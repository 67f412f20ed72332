import { Data3DTexture, HalfFloatType, type IUniform, type Scene, Vector3 } from 'three';
import type { FarolEffect } from '../../frame/FarolEffect';
import type { Frame } from '../../frame/Frame';
import type { RenderItem } from '../../frame/RenderItem';
import type { TwinKind } from '../../materials/TwinKind';
import { ProbeGrid } from './ProbeGrid';
import { probedTwin } from './probedTwin';

/** Baked light of a scene, besides its lightmaps. */
export interface BakedSurroundings {
  /** Probes that light materials without a lightmap; null for none. */
  readonly grid: ProbeGrid | null;
  /**
   * Whether lightmaps and probes contain the scene's environment light: its diffuse reflection is then left out, while mirrors
   * still show it.
   */
  readonly hasSky: boolean;
}

const surroundings = new WeakMap<object, BakedSurroundings>();

/** Sets or removes (null) a scene's baked light, see {@link LightProbes}. The host still owns the textures. */
export function setBakedSurroundings(scene: Scene, baked: BakedSurroundings | null): void {
  if (baked === null) surroundings.delete(scene);
  else surroundings.set(scene, baked);
}

/** Baked light of a scene, besides its lightmaps; null for none. */
export function bakedSurroundingsOf(scene: Scene): BakedSurroundings | null {
  return surroundings.get(scene) ?? null;
}

/** Makes a black probe texture, for scenes without probes. */
function noProbes(): Data3DTexture {
  const texture = new Data3DTexture(new Uint16Array(4), 1, 1, 1);
  texture.type = HalfFloatType;
  texture.needsUpdate = true;
  return texture;
}

/**
 * Lights moving objects by a baked grid of light probes: each lit material without a `lightMap`, in every technique.
 * Light is interpolated at each pixel; outside of the grid's box it is that of the nearest face. It counts as ambient
 * light.
 *
 * @example
 * setBakedSurroundings(scene, { grid: new ProbeGrid(box, coefficients), hasSky: false });
 * farol.effects = [new LightProbes()];
 */
export class LightProbes implements FarolEffect {
  readonly name = 'light probes';
  private readonly dark = noProbes();
  private readonly uniforms: Record<string, IUniform> & {
    readonly farol_probes: IUniform<Data3DTexture>;
  } = {
    farol_probes: { value: this.dark },
    farol_probesMin: { value: new Vector3() },
    farol_probesMax: { value: new Vector3(1, 1, 1) },
    farol_probeCounts: { value: new Vector3(1, 1, 1) },
    farol_environmentShare: { value: 1 },
  };
  private readonly twins = new Map<TwinKind, TwinKind>();
  private isNeeded = false;

  get bytes(): number {
    return 0;
  }

  begin(frame: Frame): void {
    const { uniforms } = this;
    const baked = surroundings.get(frame.scene);
    this.isNeeded = baked !== undefined;
    const grid = baked?.grid ?? null;
    uniforms.farol_environmentShare.value = baked?.hasSky === true ? 0 : 1;
    uniforms.farol_probes.value = grid?.texture ?? this.dark;
    if (grid === null) return;
    (uniforms.farol_probesMin.value as Vector3).copy(grid.min);
    (uniforms.farol_probesMax.value as Vector3).copy(grid.max);
    (uniforms.farol_probeCounts.value as Vector3).copy(grid.counts);
  }

  adapt(kind: TwinKind, item: RenderItem): TwinKind {
    if (!this.isNeeded || kind.role === undefined || item.shading !== 'lit') return kind;
    let twin = this.twins.get(kind);
    if (twin === undefined) this.twins.set(kind, (twin = probedTwin(kind, this.uniforms)));
    return twin;
  }

  dispose(): void {
    this.dark.dispose();
  }
}
