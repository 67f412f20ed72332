import { angle, component, number } from '@farol/engine/fields';

/** Swings its object, a hinge whose child is the leaf, about the vertical axis. */
export default class Door extends component({
  swing: angle(1.8, { help: 'How far it opens; below 0 to the other side.' }),
  seconds: number(1, { unit: 's', min: 0.05, step: 0.1, help: 'Time from closed to open.' }),
}) {
  static override readonly help: string = 'A door that triggers open and close.';

  private isOpen = false;
  /** Opening, 0 (closed) to 1 (open). */
  private share = 0;
  /** Angle of the closed door (rad). */
  private closed = 0;

  open(): void {
    this.isOpen = true;
  }

  close(): void {
    this.isOpen = false;
  }

  toggle(): void {
    this.isOpen = !this.isOpen;
  }

  override start(): void {
    this.isOpen = false;
    this.share = 0;
    this.closed = this.gameObject.object3D.rotation.y;
  }

  override update(deltaSeconds: number): void {
    const step = (this.isOpen ? deltaSeconds : -deltaSeconds) / this.seconds;
    this.share = Math.min(1, Math.max(0, this.share + step));
    // smoothstep: slow at both ends
    const eased = this.share ** 2 * (3 - 2 * this.share);
    // changes by scripts are simulation: Stop restores the rotation
    this.gameObject.object3D.rotation.y = this.closed + eased * this.swing;
  }
}
