// What a garment costs: the cloth that it is cut from. The page shows it by this rule, and the server asks it by the same.

/** Cloth is cut off the bolt in such steps. */
export const stepCm = 5;
export const centsPerMetre = 3400;
/** What is longer by less is as long. [cm] */
const slack = 0.01;

/** What is cut off the bolt for so many centimetres. */
export const metresFor = (lengthCm) => (Math.ceil((lengthCm - slack) / stepCm) * stepCm) / 100;

export const centsFor = (lengthCm) => Math.round(metresFor(lengthCm) * centsPerMetre);

const euros = new Intl.NumberFormat('en-IE', {style: 'currency', currency: 'EUR'});
export const money = (cents) => euros.format(cents / 100);
