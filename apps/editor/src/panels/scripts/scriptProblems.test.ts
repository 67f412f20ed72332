import { ScriptError } from '@farol/engine/scripts';
import { expect, it } from 'vitest';
import type { ScriptDiagnostic } from '../../scripts/language/LanguageAnswers';
import { problemsOf } from './scriptProblems';

const types: ScriptDiagnostic = {
  ...{ kind: 'types', severity: 'error', message: 'Type', line: 3, from: 20, to: 24 },
};

it('lists what a script threw, why it cannot run, and errors of types; of one line what TypeScript says', () => {
  const thrown = {
    script: 'Spin',
    line: 7,
    column: 1,
    message: 'x is null',
    component: 'Spin',
    object: 'Lamp',
    source: '',
  };
  const failures = new Map([['Spin', thrown]]);
  const errors = new Map([['Spin', new ScriptError('Spin', 'it exports no class.', 2)]]);
  expect(problemsOf('Spin', { errors, failures }, [types])).toEqual([
    { line: 7, severity: 'error', message: 'Spin of Lamp threw: x is null' },
    { line: 2, severity: 'error', message: 'it exports no class.' },
    types,
  ]);
  const none = new Map<string, never>();
  expect(problemsOf('Other', { errors, failures }, [])).toEqual([]);
  expect(problemsOf('Spin', { errors, failures: none }, [{ ...types, kind: 'syntax' }])).toHaveLength(1);
  expect(problemsOf('Spin', { errors, failures: none }, [{ ...types, line: 2 }])).toHaveLength(1);
});
