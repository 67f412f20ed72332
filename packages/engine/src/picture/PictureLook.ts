import type { ToneMapping } from 'three';
import { Camera } from '../components/Camera';
import type { CameraComponent } from '../core/CameraComponent';
import type { SceneSettings } from '../settings/SceneSettings';
import { exposureOf } from '../settings/exposureFields';
import { toneMappings } from '../settings/toneMappings';

/** Automatic exposure by the brightness of the picture. */
export interface AutomaticExposure {
  /** Limits of the exposure value (ISO 100). */
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
  /** Automatic exposure, multiplied by `exposure`; null when off. */
  automatic: AutomaticExposure | null = null;
  depthOfField = false;
  /** Distance that is in focus (m). */
  focusDistance = 0;
  /** Distance from the focus at which blur is full (m). */
  focusRange = 0;
  focusBlur = 0;

  /** Reads the scene's settings, overridden by the active camera's own. */
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
    // three applies exposure only together with tone mapping
    if (by.exposureBy !== 'factor' && this.toneMapping === toneMappings.none) this.toneMapping = toneMappings.linear;
  }
}
