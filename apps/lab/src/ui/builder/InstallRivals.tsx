import { t } from '@farol/editing';
import { useEffect, useState } from 'preact/hooks';
import { messageOf } from '../../run/messageOf';
import { installedRivals, installRivals } from '../../competitors/installedRivals';

type Step = 'unneeded' | 'offered' | 'installing' | 'installed';

/** Button that installs other engines, on a page served by `npm start`; nothing when they are installed. */
export function InstallRivals() {
  const [step, setStep] = useState<Step>('unneeded');
  const [problem, setProblem] = useState<string | null>(null);
  useEffect(() => {
    let isOver = false;
    void installedRivals().then(({ versions, canInstall }) => {
      if (!isOver && canInstall && Object.keys(versions).length === 0) setStep('offered');
    });
    return () => {
      isOver = true;
    };
  }, []);
  const install = async (): Promise<void> => {
    setStep('installing');
    setProblem(null);
    try {
      await installRivals();
      setStep('installed');
    } catch (error) {
      setStep('offered');
      setProblem(messageOf(error));
    }
  };
  if (step === 'unneeded') return null;
  return (
    <>
      {step !== 'installed' && (
        <button type="button" disabled={step === 'installing'} onClick={() => void install()}>
          {t('Install PlayCanvas and Babylon.js')}
        </button>
      )}
      <p class="hint" role="status">
        {step === 'offered' && t('npm fetches them for the Lab alone: 200 MB on disk.')}
        {step === 'installing' && t('npm fetches them: some seconds to minutes, by the network.')}
        {step === 'installed' && t('They are installed: reload the page to measure them.')}
      </p>
      {problem && (
        <p class="problem" role="alert">
          {problem}
        </p>
      )}
    </>
  );
}
