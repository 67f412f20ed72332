import { type EngineKeyEvent, GameObject } from '@farol/engine';
import { component, number } from '@farol/engine/fields';

/** A drop of water that is falling. */
interface Drop {
  readonly object: GameObject;
  /** Velocity of the drop (m/s). */
  readonly velocity: [number, number, number];
  age: number;
}

/** Throws up drops that shine: objects that it makes while the scene plays, and takes away when they land. */
export default class Fountain extends component({
  rate: number(12, { unit: 'Hz', min: 0, max: 60, help: 'Drops a second.' }),
  speed: number(5, { unit: 'm/s', min: 0, step: 0.1, help: 'How fast they rise.' }),
}) {
  static override readonly help: string = 'Drops of light; the key F makes it pour or pause.';

  private readonly drops: Drop[] = [];
  private due = 0;
  private count = 0;
  private isOn = true;

  override onKeyDown(event: EngineKeyEvent): void {
    if (event.code === 'KeyF' && !event.repeat) this.isOn = !this.isOn;
  }

  override update(deltaSeconds: number): void {
    this.due += this.isOn ? deltaSeconds * this.rate : 0;
    for (; this.due >= 1; this.due--) this.throwDrop();
    for (const drop of this.drops) this.move(drop, deltaSeconds);
    while (this.drops.length > 0 && this.drops[0].age > 2) this.drops.shift()!.object.dispose();
  }

  override onDestroy(): void {
    for (const { object } of this.drops.splice(0)) object.dispose();
  }

  private throwDrop(): void {
    const object = new GameObject('Drop');
    object.addComponent('Light', { diffuse: [0.35, 0.7, 1], intensity: 1.2, range: 2.5 });
    object.addComponent('ObjectRenderer', { mesh: 'bulb', kind: 'basic', colour: [0.5, 0.8, 1], instanced: true });
    this.gameObject.add(object);
    // the golden angle: drops go every way, the same in every run
    const turned = this.count++ * 2.39996;
    const velocity: Drop['velocity'] = [Math.cos(turned) * 1.1, this.speed, Math.sin(turned) * 1.1];
    this.drops.push({ object, velocity, age: 0 });
  }

  private move(drop: Drop, deltaSeconds: number): void {
    const { object, velocity } = drop;
    drop.age += deltaSeconds;
    velocity[1] -= 9.81 * deltaSeconds;
    const { position } = object.object3D;
    position.x += velocity[0] * deltaSeconds;
    position.y = Math.max(0, position.y + velocity[1] * deltaSeconds);
    position.z += velocity[2] * deltaSeconds;
  }
}
