/** All groups, each with the deviation of the photographed print from it. */
import {html, nothing, svg, type TemplateResult} from 'lit';

import type {PhotoGroup} from '../../model/print/photo-reading.js';
import type {GroupName} from '../../model/print/repeating-print.js';
import type {PhotoTexts} from '../../texts/photo-texts.js';
import {groupOf, type PhotoStep} from '../../photo/photo-step.js';

/** Deviations of a full bar: twice those of the verdict "has not". */
const fullBar = {rho: 0.12, worst: 0.8};

interface GroupChoice {
  readonly words: PhotoTexts;
  readonly meanings: Readonly<Record<GroupName, string>>;
  readonly choose: (name: GroupName) => void;
}

export function photoGroups(step: PhotoStep, choice: GroupChoice): TemplateResult {
  const {words, meanings} = choice;
  return html`<section aria-label=${words.group}>
    <h3 id="groups">${words.group}</h3>
    <div class="groups" role="radiogroup" aria-labelledby="groups">
      ${step.reading.groups.map((group) => row(step, group, choice))}
    </div>
    <p class="soft">${meanings[groupOf(step)]}</p>
  </section>`;
}

function row(
  step: PhotoStep,
  {name, rho, worst, verdict}: PhotoGroup,
  {words, choose}: GroupChoice,
): TemplateResult {
  const share = verdict === 'cannot' ? 0 : Math.max(rho / fullBar.rho, worst / fullBar.worst);
  const isFound = name === step.reading.group;
  return html`<label class="group">
    <input
      type="radio"
      name="group"
      .checked=${name === groupOf(step)}
      ?disabled=${verdict === 'cannot'}
      aria-label="${name}, ${words.verdicts[verdict]}${isFound ? `, ${words.foundOne}` : ''}"
      @change=${() => {
        choose(name);
      }}
    />
    <span>${name}</span>
    ${svg`<svg viewBox="0 0 100 8" preserveAspectRatio="none" aria-hidden="true" data-verdict=${verdict}>
      <rect class="track" width="100" height="8"></rect>
      <rect width=${Math.min(100, Math.max(0, 100 * share)).toFixed(0)} height="8"></rect>
    </svg>`}
    <span class="soft"
      >${words.verdicts[verdict]}${isFound ? html` · <b>${words.foundOne}</b>` : nothing}</span
    >
  </label>`;
}
