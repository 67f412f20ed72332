import { SetFields } from '@farol/editing';
import { GameObject, Light } from '@farol/engine';
import { expect, it, vi } from 'vitest';
import { EditorDocument } from '../../model/EditorDocument';
import { SharedValues } from './SharedValues';

it('an edit of one field of many owners has that field read again, and no other', () => {
  const document = new EditorDocument();
  const lights = Array.from({ length: 10 }, (_, i) => {
    const object = new GameObject(`Lamp ${i}`);
    document.scene.add(object);
    return object.addComponent(Light, { intensity: 4, castShadow: true });
  });
  const values = new SharedValues(lights, document);
  for (const light of lights) document.ownerSignal(light).subscribe(values.forget);
  const valueOf = vi.spyOn(document.commands, 'valueOf');
  const reads = (): [unknown, unknown, number] => {
    valueOf.mockClear();
    return [values.of('intensity').value, values.of('castShadow').value, valueOf.mock.calls.length];
  };
  expect(reads()).toEqual([4, true, 20]);
  expect(reads()).toEqual([4, true, 0]);
  const dimmed = lights.map((owner) => ({ owner, name: 'intensity', value: 2 }));
  document.commands.run(new SetFields('Dim', dimmed));
  expect(reads()).toEqual([2, true, 10]);
  document.commands.undo();
  expect(reads()).toEqual([4, true, 10]);

  // an object out of the scene emits no signals
  const { gameObject } = lights[3];
  document.scene.remove(gameObject);
  lights[3].set('castShadow', false);
  document.scene.add(gameObject);
  expect(reads()).toEqual([4, null, 20]);

  // values of a recorded clip depend on the time
  let seen = 7;
  document.commands.recorder = { valueOf: () => seen, begin: () => (command) => command, interrupt() {} };
  expect(reads()).toEqual([7, 7, 20]);
  seen = 8;
  expect(reads()).toEqual([8, 8, 20]);
  document.commands.recorder = null;
  expect(reads()).toEqual([4, null, 20]);
});
