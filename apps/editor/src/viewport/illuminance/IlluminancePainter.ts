import { t } from '@farol/editing';
import type { Camera, Scene } from 'three';
import { drawsFloats } from '../drawsFloats';
import type { Painter } from '../Painter';
import type { Viewport } from '../Viewport';
import { IlluminancePicture } from './IlluminancePicture';

/** Shows the illuminance of each surface in false colours. */
export class IlluminancePainter implements Painter {
  readonly drawsHelpers = true;
  readonly isGrid = false;
  readonly isIlluminance = true;
  private readonly picture: IlluminancePicture;

  /** Prepares the picture. @throws Error naming the missing feature of the device */
  constructor(private readonly viewport: Viewport) {
    if (!drawsFloats(viewport.webgl))
      throw new Error(t('Light cannot be measured: this device cannot draw to float colour buffers.'));
    this.picture = new IlluminancePicture(viewport.webgl, () => viewport.invalidate());
  }

  render(_scene: Scene, camera: Camera): void {
    this.picture.draw(this.viewport.document.scene, camera);
    this.picture.show();
  }

  dispose(): void {
    this.picture.dispose();
  }
}
