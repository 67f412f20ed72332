import { describe, expect, it } from 'vitest';
import { CommandStack } from '../history/CommandStack';
import { FieldGesture } from './FieldGesture';
import type { FieldValue } from './Field';
import type { FieldTarget } from './FieldTarget';
import { SetFields } from './SetFields';
import { withCoordinate } from './sharedValue';

/** A lamp with a position, and a power that `set` refuses below 0. */
class Lamp implements FieldTarget {
  readonly fields = { position: {}, shadowBias: { label: 'Bias' } };
  readonly values: Record<string, FieldValue>;

  constructor(
    readonly ownerName: string,
    place: number,
    readonly check?: FieldTarget['check'],
  ) {
    this.values = { position: [place, place, place], shadowBias: place };
  }

  getAuthored(name: string): FieldValue {
    return this.values[name];
  }

  set(name: string, value: FieldValue): void {
    if (name === 'shadowBias' && !this.check && (value as number) < 0) throw new Error('must be at least 0');
    this.values[name] = value;
  }
}

const positions = (lamps: readonly Lamp[]): FieldValue[] => lamps.map(({ values }) => values.position);

describe('FieldGesture', () => {
  it('edits one coordinate of several in one step, and leaves the others as each has them', () => {
    const lamps = [new Lamp('Lamp', 1), new Lamp('Lamp', 2)];
    const commands = new CommandStack();
    const gesture = new FieldGesture(commands, lamps, 'position');
    for (const x of [5, 6, 7]) gesture.preview(withCoordinate(0, x));
    expect(gesture.isOpen).toBe(true);
    expect(commands.history).toEqual([]);
    gesture.commit();
    expect(gesture.isOpen).toBe(false);
    expect(positions(lamps)).toEqual([
      [7, 1, 1],
      [7, 2, 2],
    ]);
    expect(commands.history).toEqual(['Set position of Lamp']);
    commands.undo();
    expect(positions(lamps)).toEqual([
      [1, 1, 1],
      [2, 2, 2],
    ]);
  });

  it('names several owners by their number where their names differ', () => {
    const commands = new CommandStack();
    new FieldGesture(commands, [new Lamp('A', 1), new Lamp('B', 2)], 'shadowBias').commit(3);
    expect(commands.history).toEqual(['Set bias of 2 objects to 3']);
  });

  it('lets an undo in the middle of a drag stand', () => {
    const [lamp] = [new Lamp('Lamp', 1)];
    const commands = new CommandStack();
    const gesture = new FieldGesture(commands, [lamp], 'shadowBias');
    gesture.preview(5);
    commands.undo();
    expect(gesture.isOpen).toBe(false);
    gesture.preview(8);
    gesture.commit();
    expect(lamp.values.shadowBias).toBe(1);
    gesture.commit(9);
    expect(lamp.values.shadowBias).toBe(9);
  });

  it('keeps nothing where all values are what they were, or where the edit is discarded', () => {
    const lamps = [new Lamp('Lamp', 1), new Lamp('Lamp', 2)];
    const commands = new CommandStack();
    const gesture = new FieldGesture(commands, lamps, 'position');
    gesture.preview(withCoordinate(1, 8));
    gesture.preview((before) => before);
    gesture.commit();
    gesture.preview(withCoordinate(1, 8));
    gesture.discard();
    expect(positions(lamps)).toEqual([
      [1, 1, 1],
      [2, 2, 2],
    ]);
    expect(commands.history).toEqual([]);
  });

  it('refuses what an owner refuses, for all of them, and keeps the preview before', () => {
    const lamps = [new Lamp('Lamp', 4), new Lamp('Lamp', 2)];
    const gesture = new FieldGesture(new CommandStack(), lamps, 'shadowBias');
    gesture.preview(3);
    expect(() => gesture.preview<number>((before) => before - 3)).toThrow(/at least 0/);
    gesture.commit();
    expect(lamps.map(({ values }) => values.shadowBias)).toEqual([3, 3]);
  });

  it('checks what is entered, and has undo put back what would be refused', () => {
    const lamp = new Lamp('Lamp', -1, (_name, value) => {
      if ((value as number) < 0) throw new Error('must be at least 0');
    });
    const commands = new CommandStack();
    const gesture = new FieldGesture(commands, [lamp], 'shadowBias');
    expect(() => gesture.preview(-2)).toThrow(/at least 0/);
    expect(lamp.values.shadowBias).toBe(-1);
    gesture.commit(2);
    commands.undo();
    expect(lamp.values.shadowBias).toBe(-1);
  });
});

describe('SetFields', () => {
  it('sets all or none', () => {
    const lamps = [new Lamp('Lamp', 1), new Lamp('Lamp', 2)];
    const edits = [7, -1].map((value, i) => ({ owner: lamps[i], name: 'shadowBias', value }));
    expect(() => new SetFields('Set', edits).do()).toThrow(/at least 0/);
    expect(lamps.map(({ values }) => values.shadowBias)).toEqual([1, 2]);
  });

  it('joins with an edit of the same fields only', () => {
    const [a, b] = [new Lamp('Lamp', 1), new Lamp('Lamp', 2)];
    const set = (owner: Lamp, value: number) => new SetFields('Set', [{ owner, name: 'shadowBias', value }]);
    const first = set(a, 5);
    first.do();
    expect(first.replaceWith(set(b, 6))).toBeNull();
    const joined = first.replaceWith(set(a, 6))!;
    expect(a.values.shadowBias).toBe(6);
    joined.undo();
    expect(a.values.shadowBias).toBe(1);
  });
});
