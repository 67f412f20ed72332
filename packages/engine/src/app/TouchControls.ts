import type { CharacterController } from '../components/CharacterController';
import type { Scene } from '../core/Scene';

/** Diameter of the stick's ring, and of its knob (CSS pixels). */
const RING = 120;
const KNOB = 48;

const disc = (size: number): Partial<CSSStyleDeclaration> => ({
  position: 'absolute',
  width: `${size}px`,
  height: `${size}px`,
  boxSizing: 'border-box',
  border: '2px solid #fff9',
  borderRadius: '50%',
  background: '#0004',
});

function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  style: Partial<CSSStyleDeclaration>,
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  Object.assign(made.style, style);
  return made;
}

/**
 * Overlays a canvas with touch controls for KeyController and CharacterController: a stick where a finger steers, and,
 * on devices with a touch screen, a jump button while the scene has a character that can jump.
 */
export class TouchControls {
  private readonly root = element('div', {
    position: 'absolute',
    inset: '0',
    overflow: 'hidden',
    pointerEvents: 'none',
  });
  private readonly ring = element('div', { ...disc(RING), display: 'none' });
  private readonly knob = element('div', { ...disc(KNOB), left: '50%', top: '50%', background: '#fff6' });
  private readonly jump = element('button', {
    ...disc(72),
    right: 'max(24px, env(safe-area-inset-right))',
    bottom: 'calc(40px + env(safe-area-inset-bottom))',
    margin: '0',
    padding: '0',
    color: '#fff',
    font: '14px sans-serif',
    pointerEvents: 'auto',
    touchAction: 'none',
    userSelect: 'none',
  });
  private readonly abort = new AbortController();
  private pointer = -1;
  private startX = 0;
  private startY = 0;

  /**
   * @param canvas - the canvas whose pointer events go to the scene
   * @param parent - positioned element of the canvas's size, which gets the controls
   * @param getScene - returns the scene that is played
   * @param jumpLabel - text of the jump button
   */
  constructor(
    private readonly canvas: HTMLElement,
    parent: HTMLElement,
    private readonly getScene: () => Scene,
    jumpLabel: string,
  ) {
    const { signal } = this.abort;
    this.ring.append(this.knob);
    this.ring.dataset.touchStick = '';
    this.jump.type = 'button';
    this.jump.textContent = jumpLabel;
    this.root.append(this.ring, this.jump);
    parent.append(this.root);
    canvas.addEventListener('pointerdown', (event) => this.press(event), { signal });
    canvas.addEventListener('pointermove', (event) => this.move(event), { signal });
    for (const type of ['pointerup', 'pointercancel'] as const)
      canvas.addEventListener(type, (event) => this.lift(event), { signal });
    this.jump.addEventListener('pointerdown', () => this.jumpers().forEach((character) => character.jump()), {
      signal,
    });
    this.update();
  }

  /** Shows or hides the jump button; called after characters may have been added or removed. */
  update(): void {
    const isTouch = matchMedia('(any-pointer: coarse)').matches;
    this.jump.hidden = !isTouch || this.jumpers().length === 0;
  }

  dispose(): void {
    this.abort.abort();
    this.root.remove();
  }

  private jumpers(): CharacterController[] {
    const characters = this.getScene().componentsOf<CharacterController>('CharacterController');
    return characters.filter((each) => each.isActive && each.keys && each.jumpHeight > 0);
  }

  /** Whether a finger on the left half of the canvas steers a controller. */
  private get hasStick(): boolean {
    const scene = this.getScene();
    return (
      scene.componentsOf('KeyController').some((each) => each.isActive) ||
      scene.componentsOf<CharacterController>('CharacterController').some((each) => each.isActive && each.keys)
    );
  }

  private press(event: PointerEvent): void {
    if (event.pointerType !== 'touch') return;
    this.update();
    const { left, top, width } = this.canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - left, event.clientY - top];
    if (this.pointer >= 0 || x >= width / 2 || !this.hasStick) return;
    Object.assign(this, { pointer: event.pointerId, startX: event.clientX, startY: event.clientY });
    Object.assign(this.ring.style, { display: '', left: `${x - RING / 2}px`, top: `${y - RING / 2}px` });
    this.place(0, 0);
  }

  private move(event: PointerEvent): void {
    if (event.pointerId === this.pointer) this.place(event.clientX - this.startX, event.clientY - this.startY);
  }

  private lift(event: PointerEvent): void {
    if (event.pointerId !== this.pointer) return;
    this.pointer = -1;
    this.ring.style.display = 'none';
  }

  /** Moves the knob by a finger's drag (CSS pixels), limited to the ring. */
  private place(right: number, down: number): void {
    const share = Math.min(1, RING / 2 / Math.max(1, Math.hypot(right, down)));
    this.knob.style.transform = `translate(calc(-50% + ${right * share}px), calc(-50% + ${down * share}px))`;
  }
}
