import { describe, expect, it } from 'vitest';
import { isComposing } from './isComposing';
import { isTyping } from './isTyping';
import { latinKey } from './latinKey';

describe('latinKey', () => {
  it.each([
    ['ы', 'KeyS', 's'], // Russian
    ['ω', 'KeyV', 'v'], // Greek
    ["'", 'KeyW', 'w'], // Hebrew
    ['ش', 'KeyA', 'a'], // Arabic
    ['&', 'Digit1', '1'], // AZERTY
    ['ç', 'Digit9', '9'],
    ['Dead', 'KeyE', 'e'],
    ['a', 'KeyQ', 'a'], // AZERTY
    ['Z', 'KeyY', 'Z'], // QWERTZ
    ['1', 'Digit1', '1'],
    ['?', 'Slash', '?'],
    ['Enter', 'Enter', 'Enter'],
    ['F2', 'F2', 'F2'],
  ])('%s on %s: %s', (key, code, expected) => expect(latinKey({ key, code })).toBe(expected));
});

it.each([
  [{ isComposing: true, keyCode: 13 }, true],
  [{ isComposing: false, keyCode: 229 }, true], // Safari
  [{ nativeEvent: { isComposing: true }, keyCode: 13 }, true], // React
  [{ nativeEvent: { isComposing: false }, keyCode: 13 }, false],
  [{ isComposing: false, keyCode: 13 }, false],
])('isComposing(%o): %s', (event, expected) => expect(isComposing(event)).toBe(expected));

it('isTyping sees a field within the shadow root that its target hosts', () => {
  const event = (target: object, ...path: object[]) => ({ target, composedPath: () => path });
  const host = { tagName: 'MY-FIELD' };
  expect(isTyping(event(host, { tagName: 'INPUT' }, host))).toBe(true);
  expect(isTyping(event(host, { tagName: 'DIV', isContentEditable: true }, host))).toBe(true);
  expect(isTyping(event(host, { tagName: 'BUTTON' }, host))).toBe(false);
  expect(isTyping(event({ tagName: 'TEXTAREA' }))).toBe(true);
  expect(isTyping({ target: null, composedPath: () => [] })).toBe(false);
});
