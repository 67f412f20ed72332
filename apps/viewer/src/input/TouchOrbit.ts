import { type CameraComponent, KeyController, MouseController } from '@farol/engine';
import { Box3, PerspectiveCamera, Sphere, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { Viewer } from '../Viewer';

/** Touch controls: one finger orbits the scene, two zoom and pan. */
export class TouchOrbit {
  /** Camera of three's controls, which ignore parents. The engine's camera, which has one, copies its pose. */
  private readonly proxy = new PerspectiveCamera();
  private readonly controls: OrbitControls;
  private readonly bounds = new Sphere();
  private readonly front = new Vector3();

  constructor(private readonly viewer: Viewer) {
    const { canvas } = viewer.app;
    // in the capture phase, before the controls' own listener
    canvas.addEventListener('pointerdown', (event) => this.begin(event.pointerType === 'touch'), { capture: true });
    canvas.addEventListener('pointerup', () => this.keysMove(true));
    canvas.addEventListener('pointercancel', () => this.keysMove(true));
    this.controls = new OrbitControls(this.proxy, canvas);
    this.controls.enabled = false;
    this.controls.addEventListener('change', () => this.follow());
  }

  private begin(touch: boolean): void {
    const camera = this.viewer.app.scene.activeCamera;
    const mouse = camera?.gameObject.getComponent(MouseController);
    if (mouse) mouse.enabled = !touch;
    // otherwise a finger on the left half of the picture would walk
    this.keysMove(!touch);
    if (touch && camera && !this.isFollowed(camera)) this.takePose(camera);
    this.controls.enabled = touch;
  }

  private keysMove(enabled: boolean): void {
    const keys = this.viewer.app.scene.activeCamera?.gameObject.getComponent(KeyController);
    if (keys) keys.enabled = enabled;
  }

  private isFollowed({ gameObject }: CameraComponent): boolean {
    return this.proxy.position.equals(gameObject.object3D.position) && this.controls.enabled;
  }

  private takePose({ gameObject, three }: CameraComponent): void {
    gameObject.object3D.updateWorldMatrix(true, false);
    gameObject.object3D.matrixWorld.decompose(this.proxy.position, this.proxy.quaternion, this.proxy.scale);
    if (three instanceof PerspectiveCamera) this.proxy.fov = three.fov;
    this.proxy.updateProjectionMatrix();
    new Box3().setFromObject(this.viewer.scene).getBoundingSphere(this.bounds);
    this.front.set(0, 0, -1).applyQuaternion(this.proxy.quaternion);
    const ahead = this.bounds.center.clone().sub(this.proxy.position).dot(this.front);
    this.controls.target.copy(this.proxy.position).addScaledVector(this.front, Math.max(ahead, three.near * 10));
    this.controls.update();
  }

  private follow(): void {
    const object = this.viewer.app.scene.activeCamera?.gameObject.object3D;
    if (!object || !this.controls.enabled) return;
    object.position.copy(this.proxy.position);
    object.quaternion.copy(this.proxy.quaternion);
    object.parent?.worldToLocal(object.position);
    this.viewer.redraw();
  }
}
