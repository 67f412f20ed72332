import { playInXR, type XRMode, xrModes, type XRStage } from './playInXR';

/**
 * Adds a button to an element for each mode of sessions that the device has; none where there is no headset.
 * @param labels - texts of the buttons
 * @param getStage - gives what a session shows that begins now
 * @param failed - gets why a session did not begin
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
