import { Matrix4, Vector2, Vector3, Vector4 } from 'three';
import type { Frame } from '../../frame/Frame';
import type { FogVolume } from './FogVolume';
import type { VolumetricFog } from './VolumetricFog';

/** Maximum number of volumes in view that are drawn; fogMedium.glsl repeats it as FAROL_MOST_VOLUMES. */
const MOST_VOLUMES = 16;

const many = <T>(make: () => T): { readonly value: T[] } => ({ value: Array.from({ length: MOST_VOLUMES }, make) });

export type MediumUniforms = FogMedium['uniforms'];

/** Settings and volumes of the fog as uniforms of fogMedium.glsl. */
export class FogMedium {
  readonly uniforms = {
    farol_fogScatter: { value: new Vector4() },
    farol_fogHeight: { value: new Vector4() },
    farol_fogDrift: { value: new Vector3() },
    farol_fogVolumes: { value: 0 },
    farol_fogVolumeInverse: many(() => new Matrix4()),
    farol_fogVolumeScatter: many(() => new Vector4()),
    farol_fogVolumeShape: many(() => new Vector2()),
  };
  /** Checksum of all settings except time; the history is dropped when it changes. */
  settingsHash = 0;
  /** Whether the noise has moved since the last frame. */
  drifts = false;
  private lastTime = 0;
  private hasWarned = false;

  /** Reads settings and volumes for a frame. */
  read(fog: VolumetricFog, frame: Frame): void {
    const { uniforms } = this;
    const { density, albedo, height, falloff, noise, noiseSize, wind } = fog;
    const time = fog.time ?? performance.now() / 1000;
    this.settingsHash = fog.anisotropy * 3 + fog.distance * 5 + wind.x * 7 + wind.y * 11 + wind.z * 13;
    uniforms.farol_fogScatter.value.set(albedo.r * density, albedo.g * density, albedo.b * density, density);
    uniforms.farol_fogHeight.value.set(height, falloff > 0 ? 1 / falloff : 0, noise, 1 / Math.max(noiseSize, 1e-3));
    uniforms.farol_fogDrift.value.copy(wind).multiplyScalar(time);
    this.hash(uniforms.farol_fogScatter.value);
    this.hash(uniforms.farol_fogHeight.value);
    this.drifts = noise > 0 && time !== this.lastTime;
    this.lastTime = time;
    this.readVolumes(frame);
  }

  private readVolumes({ queue }: Frame): void {
    const { farol_fogVolumes, farol_fogVolumeInverse, farol_fogVolumeScatter, farol_fogVolumeShape } = this.uniforms;
    let count = 0;
    for (const item of queue.transparent) {
      const volume = item.object as FogVolume;
      if (volume.isFogVolume !== true) continue;
      item.drawn = true;
      if (count === MOST_VOLUMES) {
        this.warn();
        continue;
      }
      const { density, albedo, softness, shape, matrixWorld } = volume;
      const inverse = farol_fogVolumeInverse.value[count].copy(matrixWorld).invert();
      const scatter = farol_fogVolumeScatter.value[count];
      scatter.set(albedo.r * density, albedo.g * density, albedo.b * density, density);
      farol_fogVolumeShape.value[count].set(shape === 'sphere' ? 1 : 0, 1 / Math.max(softness, 1e-3));
      this.hash(scatter);
      for (let i = 0; i < 16; i++) this.settingsHash += inverse.elements[i] * (i + 2);
      this.settingsHash += softness * 19 + (shape === 'sphere' ? 23 : 29);
      count++;
    }
    farol_fogVolumes.value = count;
  }

  private hash({ x, y, z, w }: Vector4): void {
    this.settingsHash = this.settingsHash * 1.0625 + x + y * 2 + z * 3 + w * 5;
  }

  private warn(): void {
    if (!this.hasWarned)
      console.warn(`Farol: more than ${MOST_VOLUMES} fog volumes are in view, and the rest is not drawn; use fewer.`);
    this.hasWarned = true;
  }
}
