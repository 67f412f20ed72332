import { describe, expect, it } from 'vitest';
import type { Command } from './Command';
import { CommandStack } from './CommandStack';

/** Command that sets a number, and may merge with another one of its kind. */
class SetNumber implements Command {
  readonly forgotten: boolean[] = [];
  before = 0;

  constructor(
    readonly target: { value: number },
    readonly value: number,
    readonly joins = false,
  ) {}

  get label(): string {
    return `Set ${this.value}`;
  }

  get isEmpty(): boolean {
    return this.value === this.target.value && this.before === this.value;
  }

  do(): void {
    if (this.value < 0) throw new Error('below 0');
    this.before = this.target.value;
    this.target.value = this.value;
  }

  undo(): void {
    this.target.value = this.before;
  }

  replaceWith(next: Command): Command | null {
    if (!this.joins || !(next instanceof SetNumber)) return null;
    const { before } = this;
    next.do();
    next.before = before;
    return next;
  }

  forget(isDone: boolean): void {
    this.forgotten.push(isDone);
  }
}

describe('CommandStack', () => {
  it('lets a recorder do other commands in place of those that are run, previewed and amended', () => {
    const [target, recorded] = [{ value: 0 }, { value: 0 }];
    const stack = new CommandStack();
    let [begun, interrupted] = [0, 0];
    stack.recorder = {
      valueOf: (_, name) => (name === 'seen' ? 7 : undefined),
      begin() {
        begun++;
        return (command) => new SetNumber(recorded, (command as SetNumber).value * 10, true);
      },
      interrupt() {
        interrupted++;
      },
    };
    stack.run(new SetNumber(target, 1));
    const gesture = stack.begin();
    gesture.preview(new SetNumber(target, 2));
    gesture.preview(new SetNumber(target, 3));
    gesture.commit();
    expect([target.value, recorded.value, begun]).toEqual([0, 30, 2]);
    stack.amend(stack.last!, new SetNumber(target, 4));
    expect(recorded.value).toBe(40);
    stack.undo();
    stack.redo();
    expect([recorded.value, interrupted]).toEqual([40, 2]);
    const owner = { fields: {}, ownerName: '', getAuthored: () => 5, set() {} };
    expect([stack.valueOf(owner, 'seen'), stack.valueOf(owner, 'other')]).toEqual([7, 5]);
    stack.recorder = null;
    stack.run(new SetNumber(target, 9));
    expect([target.value, stack.valueOf(owner, 'seen')]).toEqual([9, 5]);
  });

  it.each([true, false])('makes one step of many previews (joining: %s)', (joins) => {
    const target = { value: 0 };
    const stack = new CommandStack();
    const gesture = stack.begin();
    for (const value of [1, 2, 3]) gesture.preview(new SetNumber(target, value, joins));
    expect(target.value).toBe(3);
    expect(stack.undoLabel).toBeNull();
    gesture.commit();
    expect(stack.history).toEqual(['Set 3']);
    stack.undo();
    expect(target.value).toBe(0);
    stack.redo();
    expect(target.value).toBe(3);
  });

  it.each([true, false])('leaves no trace of a discarded gesture (joining: %s)', (joins) => {
    const target = { value: 7 };
    const stack = new CommandStack();
    const gesture = stack.begin();
    gesture.preview(new SetNumber(target, 1, joins));
    gesture.preview(new SetNumber(target, 2, joins));
    gesture.discard();
    expect(target.value).toBe(7);
    expect(stack.history).toEqual([]);
    gesture.preview(new SetNumber(target, 9));
    gesture.commit();
    expect(target.value).toBe(7);
  });

  it('keeps nothing when a gesture ends where it began', () => {
    const target = { value: 4 };
    const stack = new CommandStack();
    const gesture = stack.begin();
    gesture.preview(new SetNumber(target, 5, true));
    gesture.preview(new SetNumber(target, 4, true));
    gesture.commit();
    expect(stack.history).toEqual([]);
    expect(stack.isGestureOpen).toBe(false);
  });

  it('commits an open gesture before anything else is done', () => {
    const target = { value: 0 };
    const stack = new CommandStack();
    const gesture = stack.begin();
    gesture.preview(new SetNumber(target, 1));
    stack.run(new SetNumber(target, 2));
    expect(gesture.isOpen).toBe(false);
    expect(stack.history).toEqual(['Set 1', 'Set 2']);
    stack.begin().preview(new SetNumber(target, 3));
    stack.undo();
    expect(target.value).toBe(2);
    expect(stack.redoLabel).toBe('Set 3');
  });

  it('keeps nothing of a command that throws', () => {
    const target = { value: 1 };
    const stack = new CommandStack();
    expect(() => stack.run(new SetNumber(target, -1))).toThrow('below 0');
    expect(stack.history).toEqual([]);
    const gesture = stack.begin();
    gesture.preview(new SetNumber(target, 5));
    expect(() => gesture.preview(new SetNumber(target, -1))).toThrow('below 0');
    gesture.commit();
    expect(target.value).toBe(1);
    expect(stack.history).toEqual([]);
  });

  it('drops what was undone when something else is done, and lets it go', () => {
    const target = { value: 0 };
    const stack = new CommandStack();
    const first = new SetNumber(target, 1);
    stack.run(first);
    stack.undo();
    stack.run(new SetNumber(target, 2));
    expect(stack.redo()).toBe(false);
    expect(first.forgotten).toEqual([false]);
  });

  it('forgets the oldest steps past its limit', () => {
    const target = { value: 0 };
    const stack = new CommandStack(undefined, 2);
    const commands = [1, 2, 3].map((value) => new SetNumber(target, value));
    for (const command of commands) stack.run(command);
    expect(commands[0].forgotten).toEqual([true]);
    while (stack.undo());
    expect(target.value).toBe(1);
  });

  it('forgets no step while it is held, past its limit too: release takes all of them back', () => {
    const target = { value: 0 };
    const stack = new CommandStack(undefined, 2);
    stack.run(new SetNumber(target, 1));
    stack.hold();
    const commands = [2, 3, 4, 5].map((value) => new SetNumber(target, value));
    for (const command of commands) stack.run(command);
    expect(stack.release()).toEqual(commands);
    expect(target.value).toBe(1);
    expect(stack.history).toEqual(['Set 1']);
  });

  it('knows whether the document is as it was saved', () => {
    const target = { value: 0 };
    const stack = new CommandStack();
    expect(stack.isDirty).toBe(false);
    stack.run(new SetNumber(target, 1));
    stack.markSaved();
    stack.run(new SetNumber(target, 2));
    expect(stack.isDirty).toBe(true);
    stack.undo();
    expect(stack.isDirty).toBe(false);
    stack.undo();
    expect(stack.isDirty).toBe(true);
    stack.run(new SetNumber(target, 1));
    expect(stack.isDirty).toBe(true);
  });
});

describe('CommandStack.amend', () => {
  it('joins a late command with the last step, and with no other', () => {
    const target = { value: 0 };
    const stack = new CommandStack();
    const step = new SetNumber(target, 1, true);
    stack.run(step);
    const late = new SetNumber(target, 2, true);
    expect(stack.amend(step, late)).toBe(true);
    expect([target.value, stack.history]).toEqual([2, ['Set 2']]);
    expect(stack.amend(step, new SetNumber(target, 3, true))).toBe(false);
    stack.undo();
    expect(target.value).toBe(0);
    expect(stack.amend(late, new SetNumber(target, 4, true))).toBe(false);
    expect([target.value, stack.redoLabel]).toEqual([0, 'Set 2']);
  });
});
