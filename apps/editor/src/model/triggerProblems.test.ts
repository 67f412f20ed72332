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
    'The object has no collider: nothing can enter or touch it.',
    'No object has the tag “player”.',
    'The trigger calls no method yet.',
  ]);
  const mend = (text: string): void =>
    triggerProblems(trigger)
      .find((each) => each.text === text)!
      .mend!.make()
      .do();
  mend('The object has no collider: nothing can enter or touch it.');
  expect(zone.getComponent(Collider)!.sensor).toBe(true);
  zone.getComponent(Collider)!.sensor = false;
  mend('The collider is no sensor: objects stop at it, and do not enter.');
  expect(zone.getComponent(Collider)!.sensor).toBe(true);
  // the player gets the tag that the trigger waits for
  const player = new GameObject('Player');
  player.addComponent(CharacterController);
  scene.add(player);
  mend('No object has the tag “player”.');
  expect(player.tags).toEqual(['player']);
  mend('The trigger calls no method yet.');
  expect([trigger.method, texts()]).toEqual(['GameObject.toggle', []]);

  trigger.method = 'AudioSource.play';
  expect(texts()).toEqual(['Lamp has no AudioSource.play.']);
  lamp.dispose();
  mend('The object that the trigger calls no longer exists.');
  expect(trigger.target).toBeNull();
  // collision events need a collider that is no sensor
  trigger.event = 'collisionEnter';
  expect(texts()[0]).toBe('The collider is a sensor: objects pass it, and do not collide.');
  trigger.event = 'pointerClick';
  expect(texts()).toEqual(['Zone has no AudioSource.play.']);
});
