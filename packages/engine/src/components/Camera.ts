import { angle, boolean, choice, number } from '@farol/editing/fields';
import { Matrix4, OrthographicCamera, PerspectiveCamera } from 'three';
import { component } from '../core/Component';
import type { NewObject } from '../core/NewObject';
import type { Transform } from '../core/Transform';
import { exposureFields } from '../settings/exposureFields';
import { focusFields } from '../settings/focusFields';
import { toneMappingLabels, toneMappingNames } from '../settings/toneMappings';

const perspective = { visibleWhen: { field: 'projection', equals: ['perspective'] } };

/**
 * Camera at a GameObject, facing its front (-Z). Owns a three camera below the object's object3D. View and projection
 * are the two matrices of thesis 3.2.5.4.
 */
export class Camera extends component({
  projection: choice('perspective', ['perspective', 'orthographic'], { help: 'How depth shows.' }),
  fov: angle(Math.PI / 3, {
    min: 0.01,
    max: 3.1,
    help: 'Vertical field of view.',
    label: 'Field of view',
    ...perspective,
  }),
  size: number(10, {
    unit: 'm',
    min: 0.001,
    help: 'Height of the view.',
    visibleWhen: { field: 'projection', equals: ['orthographic'] },
  }),
  autoAspect: boolean(true, { help: "Take the canvas's ratio of width to height.", label: 'Aspect of the canvas' }),
  aspect: number(16 / 9, {
    min: 0.01,
    max: 100,
    step: 0.01,
    help: 'Width over height.',
    visibleWhen: { field: 'autoAspect', equals: [false] },
  }),
  near: number(0.1, { unit: 'm', min: 0.0001, help: 'Nearer things are not drawn.' }),
  far: number(200, { unit: 'm', min: 0.001, help: 'Farther things are not drawn.' }),
  toneMapping: choice('scene', ['scene', ...toneMappingNames], {
    help: 'Tone mapping of what this camera sees.',
    label: 'Tone mapping',
    optionLabels: { scene: 'Of the scene', ...toneMappingLabels },
  }),
  ...exposureFields('scene', 'Of the scene'),
  exposureCompensation: number(0, {
    min: -20,
    max: 20,
    step: 0.1,
    help: 'Exposure compensation: 1 is twice the light, -1 half of it. Needs a tone mapping.',
    label: 'Exposure compensation',
  }),
  depthOfField: choice('scene', ['scene', 'off', 'own'], {
    help: 'Depth of field: the scene’s, none, or one of this camera.',
    label: 'Depth of field',
    optionLabels: { scene: 'Of the scene', off: 'Off', own: 'Own' },
  }),
  ...focusFields({ visibleWhen: { field: 'depthOfField', equals: ['own'] } }),
}) {
  static override readonly typeName: string = 'Camera';
  static override readonly icon: string = 'camera';
  static override readonly unique: boolean = true;
  static override readonly help: string = 'A view of the scene.';
  static override readonly newObjects: readonly NewObject[] = [{ label: 'Camera' }];

  private camera: PerspectiveCamera | OrthographicCamera | null = null;
  private canvasAspect = 16 / 9;

  /** The three camera; replaced when `projection` changes. @throws Error when the component is on no GameObject */
  get three(): PerspectiveCamera | OrthographicCamera {
    if (!this.camera) throw new Error('This Camera is on no GameObject: add it with gameObject.addComponent.');
    return this.camera;
  }

  /** View matrix (world to camera space): a copy, up to date. */
  get viewMatrix(): Matrix4 {
    this.updateViewMatrix();
    return this.three.matrixWorldInverse.clone();
  }

  /** The matrix from the camera's space to clip space: a copy. */
  get projectionMatrix(): Matrix4 {
    return this.three.projectionMatrix.clone();
  }

  /**
   * Turns the camera to `target`; with two arguments it is moved to the first and faces the second. See
   * Transform.lookAt.
   */
  lookAt(...args: Parameters<Transform['lookAt']>): void {
    this.gameObject.transform.lookAt(...args);
    this.updateViewMatrix();
  }

  /** Updates the view matrix from the object's model matrix. Drawing does so by itself. */
  updateViewMatrix(): void {
    this.three.updateWorldMatrix(true, false);
  }

  /**
   * Sets a perspective projection.
   * @param fov - vertical field of view in radians
   * @param aspect - width over height; null for the canvas's
   * @param near - metres, above 0
   * @param far - metres, above `near`
   */
  setPerspective(fov: number, aspect: number | null, near: number, far: number): void {
    this.projection = 'perspective';
    this.fov = fov;
    this.autoAspect = aspect === null;
    if (aspect !== null) this.aspect = aspect;
    this.near = near;
    this.far = far;
  }

  /** Sets the size of the canvas, in any unit, for the aspect ratio; does not count as an edit. */
  setViewport(width: number, height: number): void {
    const aspect = width > 0 && height > 0 ? width / height : 1;
    if (aspect === this.canvasAspect) return;
    this.canvasAspect = aspect;
    if (this.camera) this.applyProjection(this.camera);
  }

  override onAttach(): void {
    this.makeCamera();
  }

  override onDetach(): void {
    this.camera?.removeFromParent();
    this.camera = null;
  }

  override onFieldChanged(name: string): void {
    if (name === 'projection') this.makeCamera();
    else this.applyProjection(this.three);
  }

  private makeCamera(): void {
    this.camera?.removeFromParent();
    this.camera = this.projection === 'orthographic' ? new OrthographicCamera() : new PerspectiveCamera();
    this.applyProjection(this.camera);
    this.gameObject.object3D.add(this.camera);
  }

  private applyProjection(camera: PerspectiveCamera | OrthographicCamera): void {
    const aspect = this.autoAspect ? this.canvasAspect : this.aspect;
    camera.near = this.near;
    camera.far = Math.max(this.far, this.near * 1.001);
    if (camera instanceof PerspectiveCamera) {
      camera.fov = (this.fov * 180) / Math.PI;
      camera.aspect = aspect;
    } else {
      camera.top = this.size / 2;
      camera.right = camera.top * aspect;
      camera.bottom = -camera.top;
      camera.left = -camera.right;
    }
    camera.updateProjectionMatrix();
  }
}
