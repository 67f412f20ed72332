import { expect, it } from 'vitest';
import type { Session } from '../model/Session';
import type { Gizmo } from '../viewport/Gizmo';
import { actOfKey } from './actOfKey';

const done: string[] = [];
const session = {
  commands: { undo: () => done.push('undo'), redo: () => done.push('redo') },
} as unknown as Session;

const press = (values: object): string => {
  const gizmo = { mode: 'none', space: 'local' };
  const target = { tagName: 'DIV' };
  const event = {
    altKey: false,
    ctrlKey: false,
    metaKey: false,
    shiftKey: false,
    target,
    composedPath: () => [target],
  };
  done.length = 0;
  actOfKey(session, gizmo as unknown as Gizmo, { ...event, ...values } as unknown as KeyboardEvent)?.();
  return done[0] ?? gizmo.mode;
};

it.each([
  [{ key: 'w', code: 'KeyW' }, 'translate'],
  [{ key: 'ц', code: 'KeyW' }, 'translate'], // Russian
  [{ key: 'z', code: 'KeyW' }, 'none'], // AZERTY
  [{ key: 'ζ', code: 'KeyZ', ctrlKey: true }, 'undo'], // Greek
  [{ key: 'Ζ', code: 'KeyZ', metaKey: true, shiftKey: true }, 'redo'],
  [{ key: 'w', code: 'KeyW', isComposing: true }, 'none'],
  [{ key: 'w', code: 'KeyW', target: { tagName: 'TEXTAREA' } }, 'none'],
  [{ key: 'w', code: 'KeyW', composedPath: () => [{ tagName: 'INPUT' }, {}] }, 'none'],
])('%o: %s', (event, expected) => expect(press(event)).toBe(expected));
