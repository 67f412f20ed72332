import { type Intersection, Vector2, Vector3 } from 'three';
import { hitPoint } from './rayHits';
import { callEvent } from './callEvent';
import type { EnginePointerEvent, ObjectPointerEvent } from './events';
import { gameObjectOf } from './gameObjectOf';
import type { GameObject } from './GameObject';
import type { Scene } from './Scene';
import type { SceneIndex } from './SceneIndex';

/** Greatest distance (CSS pixels) between press and release of a click. */
const CLICK_REACH = 10;

/** Number of frames between picks under a resting pointer, since objects may move. */
const RESTING_FRAMES = 8;

type PointerMethod = 'onPointerOver' | 'onPointerOut' | 'onPointerPress' | 'onPointerRelease' | 'onPointerClick';

/** State of one pointer: a mouse, a pen or a finger. */
interface Pointer {
  readonly id: number;
  /** Object under the pointer; null for none. */
  over: GameObject | null;
  /** Point under the pointer on `over`, in world space (m). */
  readonly point: Vector3;
  distance: number;
  /** Object under the pointer when the primary button was pressed; null for none. */
  pressed: GameObject | null;
  pressX: number;
  pressY: number;
  /** Last move event, handled in the next frame; null for none. */
  moved: EnginePointerEvent | null;
  /** Last event of the pointer, of any type. */
  last: EnginePointerEvent;
  /** Frames since the last pick under the pointer. */
  rested: number;
}

const place = new Vector2();

const belongsToObject = (hit: Intersection): boolean => gameObjectOf(hit.object, hit.instanceId) !== null;

/** Nearest common ancestor of two objects, where each object counts as its own ancestor; null for none. */
function nearestAbove(one: GameObject | null, other: GameObject | null): GameObject | null {
  for (let each = one; each; each = each.parent)
    for (let below = other; below; below = below.parent) if (below === each) return each;
  return null;
}

/** Finds the objects under pointers, and calls their components: see `Component.onPointerOver`. */
export class ScenePointer {
  private readonly pointers: Pointer[] = [];

  constructor(
    private readonly scene: Scene,
    private readonly index: SceneIndex,
  ) {}

  /** Handles a pointer event. A move waits for the next frame, since many may arrive in one. */
  handleEvent(event: EnginePointerEvent): void {
    const { type, pointerId } = event;
    if (type === 'wheel') return;
    const isWanted = this.isWanted();
    let pointer = this.pointers.find(({ id }) => id === pointerId);
    if (!pointer) {
      if (!isWanted || type === 'leave') return;
      pointer = {
        id: pointerId,
        over: null,
        point: new Vector3(),
        distance: 0,
        pressed: null,
        pressX: 0,
        pressY: 0,
        moved: null,
        last: event,
        rested: 0,
      };
      this.pointers.push(pointer);
    }
    pointer.last = event;
    if (type === 'move') {
      pointer.moved = event;
      return;
    }
    pointer.moved = null;
    if (type === 'leave' || !isWanted) {
      this.pointers.splice(this.pointers.indexOf(pointer), 1);
      this.enter(pointer, null, event);
      return;
    }
    pointer.rested = 0;
    this.aim(pointer, event);
    if (type === 'down') this.press(pointer, event);
    else this.release(pointer, event);
  }

  /** Handles the moves since the last frame, and objects that moved under a resting pointer. */
  update(): void {
    const { pointers } = this;
    for (let i = 0; i < pointers.length; i++) {
      const pointer = pointers[i];
      const { moved } = pointer;
      if (!moved && ++pointer.rested < RESTING_FRAMES) continue;
      pointer.moved = null;
      pointer.rested = 0;
      if (this.isWanted()) this.aim(pointer, moved ?? pointer.last);
    }
  }

  /** Forgets all pointers, without calling components. */
  reset(): void {
    this.pointers.length = 0;
  }

  /** Forgets an object that leaves the scene; its parent counts as under the pointer. */
  forget(gameObject: GameObject): void {
    for (const pointer of this.pointers) {
      if (pointer.over === gameObject) pointer.over = gameObject.parent;
      if (pointer.pressed === gameObject) pointer.pressed = null;
    }
  }

  private isWanted(): boolean {
    const { array } = this.index.pointable;
    for (let i = 0; i < array.length; i++) {
      if (array[i].isActive && array[i].listensTo?.('pointer') !== false) return true;
    }
    return false;
  }

  /** Picks the object under a pointer. */
  private aim(pointer: Pointer, event: EnginePointerEvent): void {
    const camera = this.scene.pointerCamera ?? this.scene.activeCamera?.three;
    const hit = camera ? hitPoint(this.scene, camera, place.set(event.ndcX, event.ndcY), belongsToObject) : null;
    const object = hit && gameObjectOf(hit.object, hit.instanceId);
    if (object !== pointer.over) this.enter(pointer, object, event, hit);
    else if (hit) {
      pointer.point.copy(hit.point);
      pointer.distance = hit.distance;
    }
  }

  private enter(
    pointer: Pointer,
    object: GameObject | null,
    event: EnginePointerEvent,
    hit: Intersection | null = null,
  ): void {
    const left = pointer.over;
    const end = nearestAbove(left, object);
    pointer.over = object;
    if (left) this.tell('onPointerOut', left, pointer, event, end);
    if (!hit || !object) return;
    pointer.point.copy(hit.point);
    pointer.distance = hit.distance;
    this.tell('onPointerOver', object, pointer, event, end);
  }

  private press(pointer: Pointer, event: EnginePointerEvent): void {
    const { over } = pointer;
    if (event.button === 0) {
      pointer.pressed = over;
      pointer.pressX = event.x;
      pointer.pressY = event.y;
    }
    if (over) this.tell('onPointerPress', over, pointer, event);
  }

  private release(pointer: Pointer, event: EnginePointerEvent): void {
    const { over, pressed } = pointer;
    if (event.button === 0) pointer.pressed = null;
    if (!over) return;
    this.tell('onPointerRelease', over, pointer, event);
    if (event.button !== 0 || !pressed) return;
    if (Math.hypot(event.x - pointer.pressX, event.y - pointer.pressY) > CLICK_REACH) return;
    // a click goes to the nearest common ancestor, as in HTML
    const clicked = nearestAbove(over, pressed);
    if (clicked) this.tell('onPointerClick', clicked, pointer, event);
  }

  /** Calls the components of an object and of its ancestors up to `end`, exclusive. */
  private tell(
    method: PointerMethod,
    object: GameObject,
    { point, distance }: Pointer,
    event: EnginePointerEvent,
    end: GameObject | null = null,
  ): void {
    const propagation = { isStopped: false };
    const stopPropagation = (): void => {
      propagation.isStopped = true;
    };
    const told: ObjectPointerEvent = { ...event, target: object, point: point.clone(), distance, stopPropagation };
    let each: GameObject | null = object;
    while (each !== null && each !== end && !propagation.isStopped) {
      const { parent }: GameObject = each;
      for (const component of [...each.components]) if (component.isActive) callEvent(component, method, told);
      each = parent;
    }
  }
}
