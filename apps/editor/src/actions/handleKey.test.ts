import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import type { EditorApi } from '../api/EditorApi';
import { handleKey } from './handleKey';

class FakeElement {
  /** A stub element. @param also - another selector that the element matches */
  constructor(
    readonly tagName: string,
    readonly type = 'text',
    private readonly also = '',
  ) {}
  readonly isContentEditable = false;
  isLeft = false;
  matches(selector: string): boolean {
    return selector.split(', ').some((each) => each === this.tagName.toLowerCase() || each === this.also);
  }
  blur(): void {
    this.isLeft = true;
  }
  focus(): void {}
}
class FakeInput extends FakeElement {}
class FakeTextArea extends FakeElement {}

const done: string[] = [];
const action = (id: string, ...keys: string[]) => ({ id, keys, run: () => done.push(id) });
const editor = {
  actions: {
    list: [
      action('measure', 'M', 'Shift+M'),
      action('remove', 'Delete', 'Backspace'),
      action('keys', '?'),
      action('deselect', 'Escape'),
    ],
  },
  keys: { keysOf: ({ keys = [] }: { keys?: readonly string[] }) => keys },
  dialogs: { current: null },
  viewport: { keysGoToScene: false, farol: { techniques: {} } },
  recentFiles: { list: [] },
  panels: { list: [] },
  attempt: (run: () => void) => run(),
} as unknown as EditorApi;

const press = (event: object, ...path: FakeElement[]): boolean => {
  const held = { ctrlKey: false, metaKey: false, shiftKey: false, altKey: false, defaultPrevented: false };
  const whole = { ...held, code: '', target: path.at(-1), composedPath: () => path, ...event };
  return handleKey(editor, whole as unknown as KeyboardEvent, false);
};

beforeEach(() => {
  done.length = 0;
  vi.stubGlobal('Element', FakeElement);
  vi.stubGlobal('HTMLElement', FakeElement);
  vi.stubGlobal('HTMLInputElement', FakeInput);
  vi.stubGlobal('HTMLTextAreaElement', FakeTextArea);
});
afterEach(() => {
  vi.unstubAllGlobals();
});

it('leaves keys to a text field, also within a shadow root, whose host is the target', () => {
  const host = new FakeElement('MY-FIELD');
  expect(press({ key: 'Backspace' }, new FakeInput('INPUT'), host)).toBe(false);
  expect(press({ key: 'Backspace' }, new FakeTextArea('TEXTAREA'), host)).toBe(false);
  expect(press({ key: 'Backspace' }, new FakeElement('DIV'), host)).toBe(true);
  expect(done).toEqual(['remove']);
});

it("leaves an input method's keys to it", () => {
  expect(press({ key: 'Backspace', isComposing: true }, new FakeElement('BODY'))).toBe(false);
  expect(press({ key: 'Backspace', isComposing: false, keyCode: 229 }, new FakeElement('BODY'))).toBe(false);
  expect(done).toEqual([]);
});

it('prefers the sign that a layout types to the place of its key: "?" of AZERTY is Shift and KeyM', () => {
  press({ key: '?', code: 'KeyM', shiftKey: true });
  press({ key: 'ь', code: 'KeyM' });
  expect(done).toEqual(['keys', 'measure']);
});

it('leaves a control of a field by Escape, and deselects by the next one', () => {
  const row = new FakeElement('DIV', '', '.field');
  for (const path of [[new FakeInput('INPUT', 'checkbox')], [new FakeElement('BUTTON'), row]]) {
    expect(press({ key: 'Escape' }, ...path)).toBe(true);
    expect(path[0].isLeft).toBe(true);
    expect(done).toEqual([]);
  }
  press({ key: 'Escape' }, new FakeElement('BODY'));
  expect(done).toEqual(['deselect']);
});

it('leaves letters to a picker that opens, while its button still has the focus', () => {
  const trigger = new FakeElement('BUTTON', '', '[aria-haspopup][aria-expanded="true"]');
  expect(press({ key: 'm', code: 'KeyM' }, trigger)).toBe(false);
  expect(press({ key: 'm', code: 'KeyM' }, new FakeElement('BUTTON'))).toBe(true);
  expect(done).toEqual(['measure']);
});
