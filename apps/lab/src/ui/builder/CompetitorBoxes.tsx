import { t } from '@farol/editing';
import { useId } from 'preact/hooks';
import { competitorNames, type CompetitorWords } from '../../competitors/competitorNames';
import { competitorLabel } from '../../words/names';
import { InstallRivals } from './InstallRivals';

const groups: readonly [CompetitorWords['kind'], string][] = [
  ['farol', 'Farol’s techniques'],
  ['three', 'three.js'],
  ['rival', 'Other engines'],
];
const entries: [string, CompetitorWords][] = Object.entries(competitorNames);

interface CompetitorBoxesProps {
  chosen: readonly string[];
  /** Reason, by key, why a competitor cannot draw here; undefined while unknown, null if it can. */
  unavailable: Readonly<Record<string, string | null>>;
  onChange(chosen: readonly string[]): void;
}

/** Checkboxes that choose the competitors; a run measures them in the order of this list. */
export function CompetitorBoxes({ chosen, unavailable, onChange }: CompetitorBoxesProps) {
  const id = useId();
  const choose = (names: readonly string[], isOn: boolean): void => {
    const next = new Set(chosen);
    for (const name of names) {
      if (isOn) next.add(name);
      else next.delete(name);
    }
    onChange(entries.map(([name]) => name).filter((name) => next.has(name)));
  };
  return (
    <fieldset class="competitors">
      <legend>{t('Who is measured')}</legend>
      {groups.map(([kind, label]) => {
        const names = entries.filter(([, words]) => words.kind === kind).map(([name]) => name);
        const any = names.some((name) => chosen.includes(name));
        return (
          <div key={kind} role="group" aria-labelledby={`${id}-${kind}`}>
            <div class="group-head">
              <span id={`${id}-${kind}`}>{t(label)}</span>
              <button type="button" class="quiet" onClick={() => choose(names, !any)}>
                {any ? t('None') : t('All')}
                <span class="visually-hidden"> {t('of {group}', { group: t(label) })}</span>
              </button>
            </div>
            <ul class="boxes">
              {names.map((name) => (
                <CompetitorBox
                  key={name}
                  name={name}
                  words={competitorNames[name as keyof typeof competitorNames]}
                  isChosen={chosen.includes(name)}
                  problem={unavailable[name] ?? null}
                  onChange={(isOn) => choose([name], isOn)}
                />
              ))}
            </ul>
            {kind === 'rival' && <InstallRivals />}
          </div>
        );
      })}
    </fieldset>
  );
}

interface CompetitorBoxProps {
  name: string;
  words: CompetitorWords;
  isChosen: boolean;
  problem: string | null;
  onChange(isOn: boolean): void;
}

function CompetitorBox({ name, words, isChosen, problem, onChange }: CompetitorBoxProps) {
  const id = useId();
  return (
    <li>
      <label class="check" title={t(words.help)}>
        <input
          type="checkbox"
          checked={isChosen}
          aria-describedby={`${id}-help${problem ? ` ${id}-problem` : ''}`}
          onChange={({ currentTarget }) => onChange(currentTarget.checked)}
        />
        <span class={problem ? 'dim' : undefined}>{competitorLabel(name).replace(/^(Farol|three): /, '')}</span>
      </label>
      <span id={`${id}-help`} class="visually-hidden">
        {t(words.help)}
      </span>
      {problem && (
        <p id={`${id}-problem`} class="hint">
          {t(problem)}
        </p>
      )}
    </li>
  );
}
