import { describe, expect, it } from 'vitest';
import { combinationOf } from './combinationOf';
import { matchKey } from './matchKey';

const press = (key: string, held = '', code = ''): Parameters<typeof matchKey>[1] => ({
  key,
  code,
  ctrlKey: held.includes('Ctrl'),
  metaKey: held.includes('Meta'),
  shiftKey: held.includes('Shift'),
  altKey: held.includes('Alt'),
});

describe('matchKey', () => {
  it.each([
    ['Ctrl+Z', press('z', 'Ctrl'), true],
    ['Ctrl+Z', press('z', 'Meta'), true],
    ['Ctrl+Z', press('Z', 'Ctrl Shift'), false],
    ['Ctrl+Shift+Z', press('Z', 'Ctrl Shift'), true],
    ['Ctrl+Z', press('z'), false],
    ['W', press('w'), true],
    ['W', press('W', 'Shift'), false],
    ['W', press('w', 'Ctrl'), false],
    ['?', press('?', 'Shift'), true],
    ['?', press('/'), false],
    ['Ctrl+Alt+P', press('π', 'Ctrl Alt', 'KeyP'), true],
    ['Ctrl+Alt+P', press('π', 'Alt', 'KeyP'), false],
    ['F2', press('F2'), true],
    ['Delete', press('Delete', 'Ctrl'), false],
    ['Numpad1', press('1', '', 'Numpad1'), true],
    ['Numpad1', press('1', '', 'Digit1'), false],
    ['Numpad1', press('1', 'Ctrl', 'Numpad1'), false],
    ['1', press('1', '', 'Numpad1'), false],
    ['1', press('1', '', 'Digit1'), true],
    ['Delete', press('Delete', '', 'NumpadDecimal'), true], // NumLock is off
    ['Ctrl+S', press('ы', 'Ctrl', 'KeyS'), true], // Russian
    ['Ctrl+Shift+Z', press('Ζ', 'Ctrl Shift', 'KeyZ'), true], // Greek
    ['W', press("'", '', 'KeyW'), true], // Hebrew
    ['Ctrl+A', press('ش', 'Meta', 'KeyA'), true], // Arabic
    ['W', press('ц', 'Shift', 'KeyW'), false],
    ['1', press('&', '', 'Digit1'), true], // AZERTY
    ['Ctrl+9', press('ç', 'Ctrl', 'Digit9'), true],
    ['Q', press('a', '', 'KeyQ'), false],
    ['1', press('1', 'Shift', 'Digit1'), false],
    ['?', press('?', 'Shift', 'KeyM'), true],
  ])('%s for %o: %s', (combination, event, expected) => {
    expect(matchKey(combination, event)).toBe(expected);
  });
});

describe('combinationOf', () => {
  it.each([
    [press('z', 'Ctrl'), 'Ctrl+Z'],
    [press('Z', 'Meta Shift'), 'Ctrl+Shift+Z'],
    [press('?', 'Shift'), '?'],
    [press('π', 'Ctrl Alt', 'KeyP'), 'Ctrl+Alt+P'],
    [press('F6', 'Shift'), 'Shift+F6'],
    [press(' '), 'Space'],
    [press('7', 'Ctrl', 'Numpad7'), 'Ctrl+Numpad7'],
    [press('Home', '', 'Numpad7'), 'Home'],
    [press('Control', 'Ctrl'), null],
    [press('ы', 'Ctrl', 'KeyS'), 'Ctrl+S'],
    [press('&', 'Ctrl', 'Digit1'), 'Ctrl+1'],
    [press('Dead', 'Alt', 'KeyE'), 'Alt+E'],
    [press('?', 'Shift', 'KeyM'), '?'],
    [press('!', 'Shift', 'Digit1'), '!'],
    [press('Dead', '', 'BracketLeft'), null],
  ])('%o: %s, which matches it', (event, expected) => {
    const combination = combinationOf(event);
    expect(combination).toBe(expected);
    if (combination) expect(matchKey(combination, event)).toBe(true);
  });
});
