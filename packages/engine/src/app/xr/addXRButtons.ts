import { playInXR, type XRMode, xrModes, type XRStage } from './playInXR';

/**
 * Adds a button to an element for each kind of session that the device supports; none without a headset.
 * @param labels - texts of the buttons
 * @param getStage - returns the stage of a session that begins now
 * @param failed - called with the reason when a session does not begin
 */
export async function addXRButtons(
  parent: HTMLElement,
  labels: Readonly<Record<XRMode, string>>,
  getStage: () => XRStage,
  failed: (error: Error) => void,
): Promise<void> {
  for (const mode of await xrModes()) {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'enter-xr';
    button.textContent = labels[mode];
    button.addEventListener('click', () => void playInXR(getStage(), mode).catch(failed));
    parent.append(button);
  }
}
