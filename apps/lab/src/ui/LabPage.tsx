import { t, type Language, textLanguage } from '@farol/editing';
import { useCallback, useEffect, useRef, useState } from 'preact/hooks';
import type { Configuration } from '../plan/Configuration';
import { ownPreset } from '../own/ownPreset';
import { useOwnScene } from '../own/useOwnScene';
import { MOST_CONTEXTS } from '../plan/planOf';
import { quickFor } from '../plan/presets';
import type { LabRun } from '../results/LabRun';
import { referenceRuns } from '../results/referenceRuns';
import { RunLibrary } from '../results/RunLibrary';
import { RunStore } from '../results/RunStore';
import { surroundingsOf } from '../results/surroundings';
import { messageOf } from '../run/messageOf';
import { AppLinks } from './AppLinks';
import { Hero } from './Hero';
import { ComparedRuns } from './results/ComparedRuns';
import { Results } from './results/Results';
import { isEmptyRun } from './results/whyIncomplete';
import { RunActions } from './results/RunActions';
import { RunChoice } from './results/RunChoice';
import { LanguageSelect } from './LanguageSelect';
import { Learning } from './Learning';
import { RunPanel } from './RunPanel';
import { Setup } from './Setup';
import { planned } from './support/planned';
import { useConfiguration } from './support/useConfiguration';
import { useRun } from './support/useRun';
import { useShownRun } from './support/useShownRun';
import { useStage } from './support/useStage';
import { ThemeSelect } from './ThemeSelect';

const store = new RunStore();

/** The whole page. @param onLanguage - switches the language, and renders the page again */
export function LabPage({ onLanguage }: { onLanguage(language: Language): Promise<void> }) {
  const { configuration, problems, setConfiguration } = useConfiguration();
  const displayed = useShownRun();
  const showRun = displayed.show;
  const [pair, setPair] = useState<readonly [LabRun, LabRun] | null>(null);
  const [complaint, setComplaint] = useState<string | null>(null);
  const stage = useStage();
  const handed = useOwnScene();
  const { running, isStarting, problem, start, cancel } = useRun();
  const isRunning = running !== null;
  const plan = planned(configuration, handed.scene !== null);
  const { focus, show } = useFocusedRun(
    useCallback(
      (run: LabRun) => {
        setPair(null);
        showRun(run);
      },
      [showRun],
    ),
  );
  useEffect(() => {
    if (handed.scene) setConfiguration(ownPreset(handed.scene.name).configuration);
  }, [handed.scene, setConfiguration]);

  const keep = async (run: LabRun): Promise<void> => {
    setComplaint(null);
    try {
      await store.save(run);
    } catch (error) {
      setComplaint(messageOf(error));
    }
  };
  const measure = async (next: Configuration): Promise<void> => {
    setConfiguration(next);
    const made = planned(next, handed.scene !== null);
    if (!made.plan) return;
    setPair(null);
    const run = await start(made.plan, async () => {
      const frames = stage.frames();
      if (handed.scene) await frames.setOwnScene(handed.scene.file);
      const device = await (await frames.stageOf('forward')).device();
      return { frames, surroundings: await surroundingsOf(device, next.competitors), mostContexts: mostContexts() };
    });
    stage.close();
    if (!run) return;
    const isEmpty = isEmptyRun(run);
    show(isEmpty ? { ...run, rows: [] } : run);
    if (!isEmpty) await keep(run);
  };
  const rename = (run: LabRun, name: string): void => {
    const renamed = { ...run, name };
    displayed.show(renamed);
    void keep(renamed);
  };

  const run = running?.run ?? displayed.run;
  return (
    <>
      <header class="bar">
        <AppLinks />
        <div class="bar-choices">
          <LanguageSelect onLanguage={onLanguage} onProblem={setComplaint} />
          <ThemeSelect />
        </div>
      </header>
      <main>
        <Hero
          run={run}
          isReference={!isRunning && displayed.isReference}
          stage={stage}
          isBusy={isRunning || isStarting}
          onMeasure={() => void measure(quickFor({ software: stage.device?.software ?? false }))}
        />
        {handed.isComing && <p role="status">{t('Waiting for the scene of the page that opened the Lab …')}</p>}
        {isStarting && <p role="status">{t('Opening the frames that are measured …')}</p>}
        {running && <RunPanel running={running} onCancel={cancel} />}
        {[...problems, problem, complaint, displayed.problem, handed.problem].map(
          (each) =>
            each && (
              <p key={each} class="problem" role="alert">
                {each}
              </p>
            ),
        )}
        {handed.scene && (
          <p role="status">
            {t('Handed over, to be measured:')} <strong>{handed.scene.name}</strong>
          </p>
        )}
        <div class="columns">
          <Setup
            configuration={configuration}
            planned={plan}
            unavailable={stage.unavailable}
            ownScene={handed.scene?.name ?? null}
            isBusy={isRunning || isStarting}
            onChange={setConfiguration}
            onMeasure={() => void measure(configuration)}
          />
          {/* another language changes the key of this element, so that charts and tables are rendered anew */}
          <div class="shown" key={textLanguage()}>
            {pair ? (
              <ComparedRuns runs={pair} onClose={() => setPair(null)} />
            ) : (
              <section class="results" aria-labelledby="results-title">
                {run ? (
                  <Results
                    run={run}
                    isReference={!isRunning && displayed.isReference}
                    isRunning={isRunning}
                    title={focus}
                    actions={
                      !isRunning && (
                        <RunActions
                          run={run}
                          isReference={displayed.isReference}
                          hasOwnScene={handed.scene !== null}
                          onRename={(name) => rename(run, name)}
                          onMeasure={(again) => void measure(again)}
                          onCompare={(reference) => setPair([run, reference])}
                          onProblem={setComplaint}
                          choice={<RunChoice store={store} run={run} onOpen={show} onProblem={setComplaint} />}
                        />
                      )
                    }
                  />
                ) : (
                  <h2 id="results-title">{t('Results')}</h2>
                )}
              </section>
            )}
            <section class="results">
              <RunLibrary
                store={store}
                references={referenceRuns}
                current={displayed.run?.id ?? null}
                onOpen={show}
                onCompare={(a, b) => setPair([a, b])}
                onRename={(id, name) => displayed.run?.id === id && displayed.show({ ...displayed.run, name })}
              />
            </section>
            <Learning stage={stage} isBusy={isRunning || isStarting} />
          </div>
        </div>
      </main>
    </>
  );
}

/** Displays runs and moves the focus to their title, since the focused element may be removed or far away. */
function useFocusedRun(showRun: (run: LabRun) => void) {
  const focus = useRef<HTMLHeadingElement>(null);
  const [count, setCount] = useState(0);
  const show = useCallback(
    (run: LabRun) => {
      showRun(run);
      setCount((now) => now + 1);
    },
    [showRun],
  );
  useEffect(() => {
    const title = focus.current;
    if (count === 0 || !title) return;
    title.focus({ preventScroll: true });
    const { top } = title.getBoundingClientRect();
    if (top < 0 || top > innerHeight / 2) title.scrollIntoView({ block: 'start' });
  }, [count]);
  return { focus, show };
}

/** Maximum number of WebGL contexts in this browser. */
function mostContexts(): number {
  return matchMedia('(pointer: coarse) and (width < 900px)').matches ? MOST_CONTEXTS.phone : MOST_CONTEXTS.desktop;
}
