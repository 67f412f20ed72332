import type { FieldValue } from '@farol/editing/fields';
import { describe, expect, test } from 'vitest';
import './index';
import type { ClipEvent } from '../assets/clips/ClipData';
import { Component } from '../core/Component';
import { createRandom } from '../base/createRandom';
import { GameObject } from '../core/GameObject';
import { stage, type Stage } from './testing/clipStage';

describe('calls the methods of events', () => {
  const calls: [string, unknown][] = [];
  class Listener extends Component {
    static override readonly typeName = 'Listener';
    onStep(...values: unknown[]): void {
      calls.push(['step', values.length === 0 ? 'nothing' : values[0]]);
    }
    onEnd(): void {
      calls.push(['end', null]);
    }
    onBreak(): void {
      throw new Error('broken');
    }
  }
  const events: ClipEvent[] = [
    { time: 0, method: 'onStep', value: 0 },
    { time: 0.5, method: 'onStep', value: 0.5 },
    { time: 1.25, method: 'onStep', value: 1.25 },
    { time: 2, method: 'onStep', value: 2 },
  ];
  const told = (): unknown[] => calls.splice(0).map(([, value]) => value);

  function listening(values: Record<string, FieldValue>, list = events): Stage {
    const made = stage({ events: list }, values);
    const below = new GameObject('Below');
    made.object.add(below);
    below.addComponent(Listener);
    calls.length = 0;
    return made;
  }

  /** Expected event calls from time 0 to `until` (s), counted in each pass of the clip. */
  function expected(wrap: string, speed: number, until: number): number[] {
    const found: [number, number][] = [];
    for (let pass = 0; pass < 400; pass++) {
      for (const { time } of events) {
        const ahead = wrap === 'ping-pong' ? pass % 2 === (speed < 0 ? 1 : 0) : speed > 0;
        const at = pass * 2 + (ahead ? time : 2 - time);
        const isTurn = wrap === 'ping-pong' && pass > 0 && at === pass * 2;
        if (at <= until * Math.abs(speed) && !isTurn && (wrap !== 'once' || pass === 0)) found.push([at, time]);
      }
    }
    const order = wrap === 'ping-pong' || speed > 0 ? 1 : -1;
    return found
      .map(([at, time], i) => ({ at, time, i: wrap === 'ping-pong' ? i : i * order }))
      .toSorted((a, b) => a.at - b.at || Math.floor(Math.abs(a.i) / 4) - Math.floor(Math.abs(b.i) / 4))
      .map(({ time }) => time);
  }

  test.each(
    ['once', 'loop', 'ping-pong'].flatMap((wrap) => [1, -1, 2.5, -0.75].map((speed) => [wrap, speed] as const)),
  )('%s at speed %f: each once in each pass, by small frames and big ones', (wrap, speed) => {
    const random = createRandom(11);
    for (const longest of [0.01, 0.3, 3, 40]) {
      const { scene } = listening({ wrap, speed });
      for (let i = 0; i < 60 && scene.time < 80; i++) scene.update(random() * longest);
      expect(told()).toEqual(expected(wrap, speed, scene.time));
    }
  });

  test('at exact turns and ends too', () => {
    const { scene } = listening({ wrap: 'ping-pong' });
    for (let i = 0; i < 16; i++) scene.update(0.5);
    expect(told()).toEqual([0, 0.5, 1.25, 2, 1.25, 0.5, 0, 0.5, 1.25, 2, 1.25, 0.5, 0]);
    const looped = listening({ wrap: 'loop' });
    for (let i = 0; i < 5; i++) looped.scene.update(1);
    expect(told()).toEqual([0, 0.5, 1.25, 2, 0, 0.5, 1.25, 2, 0, 0.5]);
  });

  test('not while the scene is put at times, and once it plays on only what comes then', () => {
    const { scene } = listening({ wrap: 'loop' });
    scene.setTime(1);
    scene.setTime(0.2);
    expect(told()).toEqual([]);
    scene.update(0.4);
    expect(told()).toEqual([0.5]);
  });

  test('an event at the time that a clip is put to is called, one before it is not', () => {
    const { scene, animation } = listening({ wrap: 'loop' });
    scene.update(0.7);
    expect(told()).toEqual([0, 0.5]);
    animation.time = 1.25;
    scene.update(0.1);
    expect(told()).toEqual([1.25]);
    animation.play('Rise', { time: 0.5 });
    scene.update(0.1);
    expect(told()).toEqual([0.5]);
    animation.time = 0.6;
    scene.update(0.1);
    expect(told()).toEqual([]);
  });

  test('without a value where there is none; what throws is told, and the others are called; nothing of every component is', () => {
    const { scene, errors, object } = listening({ wrap: 'once' }, [
      { time: 0, method: 'onStep' },
      { time: 0.1, method: 'onBreak' },
      { time: 0.2, method: 'dispose' },
      { time: 0.2, method: 'constructor' },
      { time: 0.3, method: 'onEnd' },
    ]);
    scene.update(1);
    expect(calls.splice(0)).toEqual([
      ['step', 'nothing'],
      ['end', null],
    ]);
    expect(errors).toEqual(['broken']);
    expect(object.children).toHaveLength(1);
  });
});
