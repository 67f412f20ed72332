import type { ArrayCamera, Camera, Light, Object3D, WebGLRenderer } from 'three';
import type { Session } from '../../frame/Session';
import type { RecordSettings } from '../../lighting/LightRecords';
import type { LightTable } from '../../lighting/LightTable';
import type { PlainPoints } from '../../lights/plainPoints';
import { drawCameras, type DrawByCamera } from '../drawCameras';

/** Draws the frames of an XR session by the cameras of three's WebXRManager, one for each eye. */
export class XRDraws implements Session {
  eye = 0;
  private readonly lights: Light[] = [];
  private readonly known = new Set<Light>();

  constructor(private readonly webgl: WebGLRenderer) {}

  /** Updates the eyes' cameras and draws by each. As in three, `camera` follows the head, and its parent moves the eyes. */
  render(scene: Object3D, camera: Camera, draw: DrawByCamera): void {
    const { xr } = this.webgl;
    camera.parent?.updateWorldMatrix(true, false);
    if (xr.cameraAutoUpdate) xr.updateCamera(camera as Parameters<typeof xr.updateCamera>[0]);
    const eyes = xr.getCamera();
    this.follow(eyes, false);
    // else three would draw with the session's camera
    xr.enabled = false;
    try {
      drawCameras(this.webgl, scene, eyes, this, draw);
    } finally {
      xr.enabled = true;
      this.follow(eyes, true);
    }
  }

  masked(
    table: LightTable,
    lights: readonly Light[],
    settings: RecordSettings,
    points: PlainPoints | null,
  ): readonly Light[] {
    const { known, lights: masked } = this;
    const { cameras } = this.webgl.xr.getCamera();
    known.clear();
    masked.length = 0;
    for (let i = cameras.length - 1; i >= 0; i--) {
      table.collect(lights, cameras[i], settings, points);
      for (const light of table.masked) {
        if (known.has(light)) continue;
        known.add(light);
        masked.push(light);
      }
    }
    return masked;
  }

  /** @param does - whether three updates the eyes' world matrices; false keeps those of WebXRManager */
  private follow(eyes: ArrayCamera, does: boolean): void {
    eyes.matrixWorldAutoUpdate = does;
    for (const eye of eyes.cameras) eye.matrixWorldAutoUpdate = does;
  }
}
