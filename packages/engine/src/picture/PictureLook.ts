import type { ToneMapping } from 'three';
import { Camera } from '../components/Camera';
import type { CameraComponent } from '../core/CameraComponent';
import type { SceneSettings } from '../settings/SceneSettings';
import { exposureOf } from '../settings/exposureFields';
import { toneMappings } from '../settings/toneMappings';

/** Exposure by how bright the picture is. */
export interface AutomaticExposure {
  /** Exposure values (ISO 100) between which it stays. */
  readonly minEV: number;
  readonly maxEV: number;
  /** Time constant of adaptation (s); 0 for at once. */
  readonly time: number;
}

/** Tone mapping and effects of a frame, from scene settings or the camera's own. One object is reused. */
export class PictureLook {
  toneMapping: ToneMapping = toneMappings.none;
  /** Factor on the linear colours of the picture. */
  exposure = 1;
  /** Exposure by how bright the picture is, which `exposure` multiplies; null for none. */
  automatic: AutomaticExposure | null = null;
  depthOfField = false;
  /** Distance that is in focus (m). */
  focusDistance = 0;
  /** Distance from the focus at which blur is full (m). */
  focusRange = 0;
  focusBlur = 0;

  /** Takes what the scene says, and what the camera that is looked through says otherwise. */
  follow(settings: SceneSettings, camera: CameraComponent | null): this {
    const own = camera instanceof Camera ? camera : null;
    const toneMapping = own === null || own.toneMapping === 'scene' ? settings.toneMapping : own.toneMapping;
    this.toneMapping = toneMappings[toneMapping];
    this.takeExposure(settings, own);
    const focus = own?.depthOfField === 'own' ? own : settings;
    this.depthOfField = own === null || own.depthOfField === 'scene' ? settings.depthOfField : focus === own;
    this.focusDistance = focus.focusDistance;
    this.focusRange = focus.focusRange;
    this.focusBlur = focus.focusBlur;
    return this;
  }

  private takeExposure(settings: SceneSettings, own: Camera | null): void {
    const by = own === null || own.exposureBy === 'scene' ? settings : own;
    const isAutomatic = by.exposureBy === 'automatic';
    const { exposureLeast: minEV, exposureMost: maxEV, exposureTime: time } = by;
    this.automatic = isAutomatic ? { minEV, maxEV, time } : null;
    const factor = exposureOf(by) ?? (isAutomatic ? 1 : settings.exposure);
    this.exposure = factor * (own === null ? 1 : 2 ** own.exposureCompensation);
    // without tone mapping three leaves the exposure out
    if (by.exposureBy !== 'factor' && this.toneMapping === toneMappings.none) this.toneMapping = toneMappings.linear;
  }
}
