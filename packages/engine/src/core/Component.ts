import type { FieldTable, FieldValue } from '../fields/Field';
import { FieldOwner } from '../fields/FieldOwner';
import type { EngineKeyEvent, EnginePointerEvent } from './events';
import type { GameObject } from './GameObject';
import type { Scene } from './Scene';

/** What the registry, the menus and the file format know of a class of components. */
export interface ComponentClass<T extends Component = Component> {
  new (): T;
  /** Name in files and menus. */
  readonly typeName: string;
  readonly fields: FieldTable;
  /** Version of its form in files; raise it, and write `migrate`, whenever a field changes its name, meaning or default. */
  readonly version: number;
  /** At most one on a GameObject. */
  readonly unique: boolean;
  /** One line for the Add menu. */
  readonly help: string;
  /** Brings field values written by an older version up to `version`. */
  migrate?(values: Record<string, unknown>, fromVersion: number): Record<string, unknown>;
}

/**
 * A part of a GameObject that gives it an ability. Its fields are declared once (see `component`), and read by the
 * inspector, the file format, undo and the tests.
 */
export abstract class Component extends FieldOwner {
  static readonly typeName: string = '';
  static readonly fields: FieldTable = {};
  static readonly version: number = 1;
  static readonly unique: boolean = false;
  static readonly help: string = '';

  private attachedObject: GameObject | null = null;
  private isEnabled = true;
  private ownId = '';

  /** Pointer events over the canvas, while the object is active and the component enabled. */
  onPointerDown?(event: EnginePointerEvent): void;
  onPointerMove?(event: EnginePointerEvent): void;
  onPointerUp?(event: EnginePointerEvent): void;
  onPointerWheel?(event: EnginePointerEvent): void;
  onKeyDown?(event: EngineKeyEvent): void;
  onKeyUp?(event: EngineKeyEvent): void;

  /** Unique in its scene and kept in files; '' until the component has been on a GameObject. */
  get id(): string {
    return this.ownId;
  }

  get componentClass(): ComponentClass {
    return this.constructor as unknown as ComponentClass;
  }

  get typeName(): string {
    return this.componentClass.typeName;
  }

  override get ownerName(): string {
    return this.typeName;
  }

  /** False switches the component off without taking it away. */
  get enabled(): boolean {
    return this.isEnabled;
  }

  set enabled(value: boolean) {
    if (value === this.isEnabled) return;
    this.isEnabled = value;
    if (this.attachedObject) {
      this.onActiveChanged();
      this.attachedObject.scene?.notify({ kind: 'enabled', component: this });
    }
  }

  /**
   * The GameObject that it is on.
   * @throws Error when it is on none
   */
  get gameObject(): GameObject {
    if (!this.attachedObject) {
      throw new Error(`This ${this.typeName} is on no GameObject: add it with gameObject.addComponent.`);
    }
    return this.attachedObject;
  }

  get isAttached(): boolean {
    return this.attachedObject !== null;
  }

  /** The scene that it is in, or null. */
  get scene(): Scene | null {
    return this.attachedObject?.scene ?? null;
  }

  /** Enabled, on a GameObject that is active together with all its ancestors. */
  get isActive(): boolean {
    return this.isEnabled && this.attachedObject !== null && this.attachedObject.activeInHierarchy;
  }

  /** The component came onto a GameObject; `gameObject` is there, `scene` perhaps not. */
  onAttach(): void {}

  /** The component is about to leave its GameObject. */
  onDetach(): void {}

  /** The GameObject came into a scene, or the component came onto a GameObject of one. */
  onEnterScene(_scene: Scene): void {}

  /** The GameObject, or the component alone, is about to leave the scene. */
  onLeaveScene(_scene: Scene): void {}

  /** A field got another value, by hand or by code. Called only while attached. */
  onFieldChanged(_name: string): void {}

  /** `isActive` may have changed: the component was enabled or disabled, or an object above it was. */
  onActiveChanged(): void {}

  /**
   * Called every frame that is simulated; only components that override it are visited.
   * @param _deltaSeconds - 0 when the scene was put at a time
   * @param _time - the scene's time in seconds
   */
  update(_deltaSeconds: number, _time: number): void {}

  /** Gives back what the component holds. It cannot be used afterwards. */
  dispose(): void {}

  protected override fieldChanged(name: string, before: FieldValue): void {
    if (!this.attachedObject) return;
    this.onFieldChanged(name);
    this.attachedObject.scene?.notify({ kind: 'field', component: this, field: name, before });
  }

  /** @internal Called by GameObject. */
  attachTo(gameObject: GameObject, id: string): void {
    this.attachedObject = gameObject;
    this.ownId = id;
    this.onAttach();
  }

  /** @internal Called by GameObject. */
  detach(): void {
    this.onDetach();
    this.attachedObject = null;
  }

  /** The authored value of every field. */
  authoredValues(): Record<string, FieldValue> {
    const values: Record<string, FieldValue> = {};
    for (const name of Object.keys(this.fields)) values[name] = this.getAuthored(name);
    return values;
  }
}
