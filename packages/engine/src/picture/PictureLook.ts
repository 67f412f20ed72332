import type { ToneMapping } from 'three';
import { Camera } from '../components/Camera';
import type { CameraComponent } from '../core/CameraComponent';
import type { SceneSettings } from '../settings/SceneSettings';
import { toneMappings } from '../settings/toneMappings';

/** Tone mapping and effects of a frame, from scene settings or the camera's own. One object is reused. */
export class PictureLook {
  toneMapping: ToneMapping = toneMappings.none;
  /** Factor on the linear colours of the picture. */
  exposure = 1;
  depthOfField = false;
  /** Distance that is in focus (m). */
  focusDistance = 0;
  /** Distance from the focus at which blur is full (m). */
  focusRange = 0;
  focusBlur = 0;

  /** Takes what the scene says, and what the camera that is looked through says otherwise. */
  take(settings: SceneSettings, camera: CameraComponent | null): this {
    const own = camera instanceof Camera ? camera : null;
    const toneMapping = own === null || own.toneMapping === 'scene' ? settings.toneMapping : own.toneMapping;
    this.toneMapping = toneMappings[toneMapping];
    this.exposure = settings.exposure * (own === null ? 1 : 2 ** own.exposureCompensation);
    const focus = own?.depthOfField === 'own' ? own : settings;
    this.depthOfField = own === null || own.depthOfField === 'scene' ? settings.depthOfField : focus === own;
    this.focusDistance = focus.focusDistance;
    this.focusRange = focus.focusRange;
    this.focusBlur = focus.focusBlur;
    return this;
  }
}
