import { CharacterController, Collider, EventTrigger, GameObject, Light, Scene } from '@farol/engine';
import { expect, it } from 'vitest';
import { triggerProblems } from './triggerProblems';

it('tells why a trigger can never fire, and mends each cause', () => {
  const scene = new Scene();
  const zone = new GameObject('Zone');
  const lamp = new GameObject('Lamp');
  lamp.addComponent(Light);
  for (const each of [zone, lamp]) scene.add(each);
  const trigger = zone.addComponent(EventTrigger, { event: 'triggerEnter', otherTag: 'player', target: lamp.id });
  const texts = (): string[] => triggerProblems(trigger).map(({ text }) => text);
  expect(texts()).toEqual([
    'It has no collider: nothing can come into it or touch it.',
    'No object has the tag “player”.',
    'It calls nothing yet.',
  ]);
  const mend = (text: string): void =>
    triggerProblems(trigger)
      .find((each) => each.text === text)!
      .mend!.make()
      .do();
  mend('It has no collider: nothing can come into it or touch it.');
  expect(zone.getComponent(Collider)!.sensor).toBe(true);
  zone.getComponent(Collider)!.sensor = false;
  mend('Its collider is no sensor: things stop at it, and do not come in.');
  expect(zone.getComponent(Collider)!.sensor).toBe(true);
  // the player gets the tag that the trigger waits for
  const player = new GameObject('Player');
  player.addComponent(CharacterController);
  scene.add(player);
  mend('No object has the tag “player”.');
  expect(player.tags).toEqual(['player']);
  mend('It calls nothing yet.');
  expect([trigger.method, texts()]).toEqual(['GameObject.toggle', []]);

  trigger.method = 'AudioSource.play';
  expect(texts()).toEqual(['Lamp has no AudioSource.play.']);
  lamp.dispose();
  mend('The object that it calls is gone.');
  expect(trigger.target).toBeNull();
  // what waits for a blow needs something solid
  trigger.event = 'collisionEnter';
  expect(texts()[0]).toBe('Its collider is a sensor: things go through it, and do not collide.');
  trigger.event = 'pointerClick';
  expect(texts()).toEqual(['Zone has no AudioSource.play.']);
});
