import type { EnginePointerEvent } from '../core/events';

/** Drag of a finger that gives full speed (CSS pixels). */
const REACH = 60;

/** A virtual stick on a touch screen, centred where a finger touches the left half of the picture. */
export class TouchStick {
  /** Deflection to the right and towards the user; full speed at a length of 1, which a long drag exceeds. */
  right = 0;
  back = 0;
  private pointer = -1;
  private startX = 0;
  private startY = 0;

  /** Whether an event is of the finger that holds the stick. */
  isHeldBy({ pointerId, pointerType }: EnginePointerEvent): boolean {
    return pointerType === 'touch' && pointerId === this.pointer;
  }

  /** @returns whether the finger now holds the stick */
  press({ pointerId, pointerType, ndcX, x, y }: EnginePointerEvent): boolean {
    if (pointerType !== 'touch' || ndcX >= 0 || this.pointer >= 0) return false;
    Object.assign(this, { pointer: pointerId, startX: x, startY: y });
    return true;
  }

  /** Follows the finger that holds the stick; other pointers do nothing. */
  move(event: EnginePointerEvent): void {
    if (!this.isHeldBy(event)) return;
    this.right = (event.x - this.startX) / REACH;
    this.back = (event.y - this.startY) / REACH;
  }

  /** Lets the stick go, if this finger holds it. */
  lift(event: EnginePointerEvent): void {
    if (this.isHeldBy(event)) this.letGo();
  }

  letGo(): void {
    this.pointer = -1;
    this.right = this.back = 0;
  }
}
