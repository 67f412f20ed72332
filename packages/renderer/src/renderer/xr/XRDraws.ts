import type { ArrayCamera, Camera, Light, Object3D, WebGLRenderer } from 'three';
import type { Frame } from '../../frame/Frame';
import type { Session } from '../../frame/Session';
import type { RecordSettings } from '../../lighting/LightRecords';
import type { LightTable } from '../../lighting/LightTable';
import type { PlainPoints } from '../../lights/plainPoints';
import { drawCameras, type DrawByCamera } from '../drawCameras';
import { afterRender, beforeRender } from '../sceneCallbacks';
import { BothEyes } from './BothEyes';

/** Number of frames after which drawing both eyes at once is tried again. */
const LATER = 300;

/** Draws the frames of an XR session by the cameras of three's WebXRManager, one for each eye. */
export class XRDraws implements Session {
  eye = 0;
  private readonly lights: Light[] = [];
  private readonly known = new Set<Light>();
  private readonly bothEyes: BothEyes;
  /** Set while one call per object draws both eyes, see `FarolOptions.multiview`; else null. */
  both: BothEyes | null = null;
  private refused = false;
  /** Number of frames for which each scene is still drawn eye by eye. */
  private readonly waits = new WeakMap<Object3D, number>();

  constructor(private readonly webgl: WebGLRenderer) {
    this.bothEyes = new BothEyes(webgl);
  }

  get adapters() {
    return this.both?.adapters ?? null;
  }

  get bytes(): number {
    return this.bothEyes.bytes;
  }

  /**
   * Updates the eyes' cameras and draws by each. As in three, `camera` follows the head, and its parent moves the eyes.
   * @param multiview - whether both eyes are drawn at once, where that is possible
   */
  render(scene: Object3D, camera: Camera, multiview: boolean, draw: DrawByCamera): void {
    const { xr } = this.webgl;
    camera.parent?.updateWorldMatrix(true, false);
    if (xr.cameraAutoUpdate) xr.updateCamera(camera as Parameters<typeof xr.updateCamera>[0]);
    const eyes = xr.getCamera();
    this.follow(eyes, false);
    // else three would draw with the session's camera
    xr.enabled = false;
    try {
      if (!multiview || !this.drawBoth(scene, eyes, draw)) drawCameras(this.webgl, scene, eyes, this, draw);
    } finally {
      xr.enabled = true;
      this.follow(eyes, true);
    }
  }

  refuses(frame: Frame, technique: string, effects: number): boolean {
    this.refused = effects > 0 || this.both!.refuses(frame, technique);
    return this.refused;
  }

  present(frame: Frame): void {
    this.both?.present(frame);
  }

  dispose(): void {
    this.bothEyes.dispose();
  }

  /** Draws both eyes at once. @returns whether they were drawn */
  private drawBoth(scene: Object3D, eyes: ArrayCamera, draw: DrawByCamera): boolean {
    const { webgl, bothEyes } = this;
    const wait = this.waits.get(scene) ?? 0;
    if (wait > 0) this.waits.set(scene, wait - 1);
    if (wait > 0 || !bothEyes.begin(scene, eyes)) return false;
    this.both = bothEyes;
    this.refused = false;
    this.eye = 0;
    try {
      const updated = beforeRender(webgl, scene, eyes);
      draw(scene, bothEyes.camera, scene.matrixWorldAutoUpdate && !updated, false, eyes, this);
      if (!this.refused) afterRender(webgl, scene, eyes);
    } finally {
      this.both = null;
      bothEyes.end();
    }
    if (this.refused) this.waits.set(scene, LATER);
    return !this.refused;
  }

  masked(
    table: LightTable,
    lights: readonly Light[],
    settings: RecordSettings,
    points: PlainPoints | null,
  ): readonly Light[] {
    const { known, lights: masked } = this;
    if (this.both !== null) return table.masked;
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
