#pragma once

/// Every threshold that more than one line of code depends on, each with its unit, its reason, and what changes with it.
/// Screen lengths are CSS pixels, world lengths metres, angles radians.
namespace dimline {

// --- Placement: lengths on screen -------------------------------------------------------------------------------------

/// px. The paper's handleSpacing (3.1, principle 2): the clearance of a final line from the silhouette and from other
/// lines. Also the unit that turns the score's terms into pixels (4.2). Larger: airier, and fewer lines fit.
inline constexpr double kHandleSpacingPx = 30.0;

/// px. By how much less than handleSpacing a line that lies on another's guide may keep from the model to stay there; nobody sees it. None: where a face leans a little, it goes off the guide and
/// back as the other one moves by a fraction of a pixel.
inline constexpr double kGuideSlackPx = 0.2;

/// px. Clearance of a label's box from the silhouette, from lines and from other labels. Below about 3 px text seems to
/// touch what it stands beside.
inline constexpr double kLabelClearancePx = 4.0;

/// px. The same from a label to the next line out, in a picture in which lines have settled: further than to the label's own line, or a number between two seems to belong to either. More: stacks of lines reach further out.
inline constexpr double kLabelClearanceSettledPx = 12.0;

/// px. Clearance that a later line keeps from an extension line it runs beside. Small: an extension line is thin and
/// quiet, and lines of neighbouring features share their ends.
inline constexpr double kExtensionClearancePx = 4.0;

/// px. How far an extension line stands off its base line's end and runs on past the final line, as in technical
/// drawing (ISO 129-1 shows about 2 mm on paper). Drawing only; a placed line's footprint includes the overshoot.
inline constexpr double kExtensionGapPx = 4.0;
inline constexpr double kExtensionOvershootPx = 5.0;

/// px. A candidate's line and label stay this far inside the viewport, so that an arrowhead is never cut in half.
inline constexpr double kViewportMarginPx = 6.0;

/// px. Below this length on screen a base line has no direction that could be trusted and a line cannot be grabbed:
/// it is hidden, "too-short" (or "foreshortened" when it points at the viewer). Authors raise it by min-length.
inline constexpr double kMinLineLengthPx = 8.0;

/// rad. A base line within this of the view direction is hidden, "foreshortened": on screen it says nothing about its length,
/// and a drag of a pixel would be a leap.
inline constexpr double kForeshortenedAngleRad = 0.165;

/// rad. The same for the plane of an arc: seen from its edge it looks like a short straight line, with an arrow that points anywhere.
inline constexpr double kArcForeshortenedAngleRad = 0.3;
/// The same for one that is hidden, so that it does not come and go at the edge: it is shown again a degree further on. Larger: an angle that can be read is missing.
inline constexpr double kArcShownAgainAngleRad = 0.32;

/// How many times as far from the viewer as its base line a line may lie in perspective, and so how much smaller it may be drawn. Larger: from near by, lines lie far behind what they measure,
/// and 34 m is drawn shorter than 19 m beside it. Smaller: more lines have no place but on the model.
inline constexpr double kMostDepthRatio = 2.5;

/// How far a line may lie from its base line along either side of the viewport, as a share of its diagonal, and one that is there already; in a small viewport so many px, which the eye takes in at once. Beyond the paper.
/// Larger: near by the model, extension lines lead across the whole picture, and nobody sees what the line measures. Smaller: more lines have no place but on the model.
inline constexpr double kMostReachShare = 0.4;
inline constexpr double kMostReachShareToStay = 0.45;
inline constexpr double kLeastReachPx = 300.0;

/// A line hidden as too short or foreshortened is shown again when it passes the threshold by this factor, so that it does not come and go at its edge; and one that is shown stays in its place outside where it is shorter by it.
/// The second is for one that has gone within kDwellFrames moved frames: at so much more than the threshold nobody disputes that it is long enough. Lower: it comes back, for short, when nobody misses it.
inline constexpr double kShowAgainFactor = 1.18;
inline constexpr double kShowAgainLatelyFactor = 1.25;

/// px. While all is shown, a line must still have a direction on screen.
inline constexpr double kShowAllLengthPx = 1.5;

/// px. How much further out than the least offset a line is tried, step by step, when its label has no room there; of the first step that has room, the least that does (kClearingPrecisionPx).
inline constexpr double kLabelPushStepPx = 10.0;
inline constexpr int kLabelPushSteps = 4;
/// In how many such steps a line that is in a tangle of lines and extension lines is tried further out, to what share of the least offset, how exactly (px) the first free
/// offset is found, and by how much (px) the last frame's line moves there in each moved frame. Further: fewer tangles, and lines farther from what they measure. Less exactly:
/// such a line trembles as the camera moves. Faster: fewer tangles, and lines beyond it have to leap.
inline constexpr int kClearingSteps = 6;
inline constexpr double kMostClearedRatio = 1.45;
inline constexpr double kClearingPrecisionPx = 0.125;
inline constexpr double kClearPx = 10.0;

/// px. Length of an arrowhead along its line, at rest; half its width across.
inline constexpr double kArrowLengthPx = 12.0;
inline constexpr double kArrowHalfWidthPx = 4.0;

/// px. Radius of the balls with which a line ends that its author gave skin=sphere. About as much ink as an arrowhead.
inline constexpr double kSphereRadiusPx = 5.0;

/// px. Space between a label and the line that is interrupted for it, and between a label and the arrowhead.
inline constexpr double kLabelPaddingPx = 4.0;

/// px. Size of the text on dimension lines. The advance table in placement/text_metrics.h is in units of this size.
inline constexpr double kLabelFontSizePx = 14.0;

/// px. A switch or a choice on the model is a pill: its height (a comfortable target for a mouse; touch gets more by its grab radius), and what it is wider
/// than its text: padding, and the switch or the chevron.
inline constexpr double kPillHeightPx = 28.0;
inline constexpr double kPillExtraWidthPx = 52.0;

/// An arc's radius as a share of the smaller side of its scope across the axis, and its least and greatest on screen (px): smaller cannot be grabbed,
/// larger dwarfs the model. Where the default angle is small the radius is greater, until the arc is so long (px): enough to see which way it opens. Longer: arcs get in the way of lines.
inline constexpr double kArcRadiusShare = 0.6;
inline constexpr double kArcMinRadiusPx = 36.0;
inline constexpr double kArcMaxRadiusPx = 140.0;
inline constexpr double kArcMinLengthPx = 18.0;

/// px. Lines of features that share a corner touch there, and by rounding reach past each other a little, which nobody sees: they cross when they do by more.
inline constexpr double kCrossingPx = 0.5;

/// px. Two lines less than this apart are seen as one. An extension line that would lie so on a dimension line is moved aside (paper 5, "Extension
/// Lines") by the second length: enough to be seen beside it, too little to seem another feature's.
inline constexpr double kSameLinePx = 1.5;
inline constexpr double kExtensionAsidePx = 4.0;

/// px. An extension line gets past another's line that reaches so far over it by a jog (placement/jogs.h), so much beyond the line's end as a share of that, where it bends by no more than this slope on either side.
/// Less: more lines run across extension lines, or change places not to. More, or steeper: the kink is seen before what it spares.
inline constexpr double kMostJoggedPx = 8.0;
inline constexpr double kJogBeyondShare = 0.3;
inline constexpr double kMostJogSlope = 0.2;

/// px2 of viewport for each parameter, from which on all lines are shown, however much in each other's way.
/// Below it one that would run into another, or through a number, is hidden: that which is placed later, mostly the longer one. To hide the shortest until none is in another's way takes many that are in nobody's.
inline constexpr double kCrowdedPx2 = 20000.0;
/// px2 of viewport for each parameter, below which no switch and no choice is shown: one covers 3,000, and more than half of it lies on the model.
inline constexpr double kPillsCrowdedPx2 = 8000.0;

// --- Placement: the score of section 4.2 ------------------------------------------------------------------------------

inline constexpr double kScoreDistance = -1.0;                           ///< lambda 1, per px
inline constexpr double kScoreLength = 0.02;                             ///< lambda 2, per px
inline constexpr double kScoreAlign = 3.0 * kHandleSpacingPx;            ///< lambda 3
inline constexpr double kScoreDamp = 0.5 * kHandleSpacingPx;             ///< lambda 4
inline constexpr double kScoreIntersect = -1.0 * kHandleSpacingPx;       ///< lambda 5
/// Beyond the paper: principle 9 weighs more than a shorter way. What was left is not gone back to within kReturnFrames moved frames unless it is better by
/// -kScoreReturn. Where all is placed anew, as after an edit, and for arcs and what is inside, the last frame's choice stays until another is better by kScoreStay
/// more than Damp. Smaller: handles change sides more often on an orbit. Larger: they stay longer on a side that is no longer the nearest.
inline constexpr double kScoreStay = 20 * kHandleSpacingPx;
inline constexpr double kScoreReturn = -14.0 * kHandleSpacingPx;
inline constexpr int kReturnFrames = 20;

/// Beyond the paper (placement/mending.h): what each line that changes its place costs an attempt to mend a frame; a leap counts as so many changes, and going back to what was left within
/// kReturnFrames as so many more. Less: lines change places for a small gain. More: what is amiss stays until a place is lost.
inline constexpr double kScoreChange = -24.0 * kHandleSpacingPx;
/// The same when a movement has ended (Placer::settle()): the picture will be looked at for long, so a change that is once more than paid for by what it brings. Less: more lines than need to change places when the
/// hand lets go. More: they rest where the movement left them, far out and along faces that have turned away.
inline constexpr double kScoreChangeSettling = -2.0 * kHandleSpacingPx;
inline constexpr double kChangesOfLeap = 3.5;
inline constexpr double kChangesOfReturn = 16.0;
/// As so many counts a change to a place that the turning view takes away at the first look ahead (Foresight): the line would soon have to change again. Less: mending puts lines where they are for a few frames only. More: it leaves more amiss.
inline constexpr double kChangesOfPassing = 9.0;
/// The price of a change, as a share, where it leaves no line at all that runs across another's extension line, since a picture without is read at a glance. Less: more such pictures, and more changes. For the last
/// of them alone: at a low price for all, lines change places without end where they are so crowded that some stay in each other's way.
inline constexpr double kChangeShareToUntangle = 0.4;
/// What it costs there that a line runs across another's extension line, that a longer line lies nearer to the model than a shorter one beside it, and that a line is inside
/// the model. A change costs once, these as long as they last, so each that lasts is worth a change or more; in px it is how far lines go for it. The first counts once more at each look ahead (placement/foresight.h)
/// at which it will be, in equal steps less at later ones.
inline constexpr double kScoreTangle = -20.0 * kHandleSpacingPx;
inline constexpr double kScoreNestedWrongly = -40.0 * kHandleSpacingPx;
inline constexpr double kScoreInside = -40.0 * kHandleSpacingPx;
/// The first two cost by so much more while the camera comes nearer or goes away, and in a first picture: what is amiss lasts long then, and lines move for other reasons
/// anyway, or have not been seen. Less: it lasts while the picture grows. More: more changes, some of which are taken back.
inline constexpr double kAmissFactor = 2.5;
/// What it costs a line inside the model to run across another's extension line, through a label, or into a line inside that is still to be placed: more than staying is worth, since
/// its other base lines are near by.
inline constexpr double kScoreAmissInside = -22.0 * kHandleSpacingPx;
/// What it costs a line inside that the model is before it: it seems to measure what it is drawn over. As much as running across something and being lost at once while the camera comes nearer. The second is
/// for a line that is there already, less than staying is worth: fewer changes at the edge of sight, and a line that is seen through the model for a little longer.
inline constexpr double kScoreBehindModel = -45.0 * kHandleSpacingPx;
inline constexpr double kScoreStaysBehindModel = -10.0 * kHandleSpacingPx;
/// What it costs a new place outside to measure such a base line: its extension lines come from behind the model, and it seems to measure what they come out from. More: lines go further for it.
inline constexpr double kScoreFromBehindModel = -5.0 * kHandleSpacingPx;
/// What it costs a line inside to measure a scope of which nothing is seen, and in proportion one that is hidden in part: the line is faint where the model is before it. More: in a row of windows the line
/// goes from one to the next as they come into view.
inline constexpr double kScoreHiddenScope = -10.0 * kHandleSpacingPx;
/// Attempts at a moved frame in which a line looks for another place, each about half as long as placing it; one in another order comes on top. More find more and cost more.
inline constexpr std::size_t kMendingAttempts = 3;
/// One in so many attempts in another order goes back to the shortest first. Fewer: an order of long ago stays when it no longer helps. More: it costs time.
inline constexpr int kShortestFirstEvery = 3;
/// Attempts more at a frame in which lines run across others' extension lines, or go back to what they left lately, each drawn at random: who looks for another place on another side, and the order, in which at most so many lines come before a
/// shorter one. Fewer: more such lines, which stay for longer. More: a tenth fewer of them, and a few changes of place more, for twice as many; each costs a frame with such lines about half as much time as
/// placing it.
inline constexpr int kShuffles = 24;
/// The same in a first picture, and of how many lines each looks for another place there and where lines settle, the shortest. More: such a picture is there later.
inline constexpr int kShufflesAtFirst = 60;
inline constexpr std::size_t kLooksAtRest = 60;
/// The same in each round in which lines settle, whether any run across others' extension lines or not: a picture that is looked at for long is worth the time. Fewer: lines are left far from what they measure. More: it
/// takes longer, for little more.
inline constexpr int kShufflesSettling = 30;
inline constexpr std::size_t kMostPuts = 3;
/// Cosine. Two places whose ways from their base lines on screen differ by less are on one side, so that a line which looks for one on another side takes neither. Less: fewer places are tried.
/// More: places are tried that do no better.
inline constexpr double kSameSideCos = 0.7;
/// Before so many of its lines' turns it is kept how an attempt stands, so that another one that begins likewise goes on from there; about 20 kB each in a viewport of 1000x1000. More: it takes memory. Fewer: lines are placed
/// again that come to the same.
inline constexpr std::size_t kMostKeptTurns = 32;
/// How often such a picture is placed, each time with a view to what was placed the time before. More: fewer lines across others' extension lines, and fewer of those through numbers; where lines settle, lines nearer to what
/// they measure; it takes longer, and beyond this many gives hardly more.
inline constexpr int kRoundsAtFirst = 2;
inline constexpr int kRoundsSettling = 4;
/// Moved frames after which any line may look for a better place, though nothing is amiss with it.
inline constexpr int kFramesToLookAround = 3;

/// Moved frames on end for which a switch or a choice that had no room or was inside the model, a line not in plain view that gave way to others, or one that could come out to an object plane, must have had
/// a better kind of place before it takes it. Fewer: it comes and goes where there is hardly any room, as in a view from near by. More: it is still missing when the movement ends.
inline constexpr int kPatienceFrames = 15;
/// The same for any line that had no room, or gave way, in a small viewport, where room is what others leave for the moment. Fewer: lines come back to be gone again. More: fewer lines are shown until the movement ends.
inline constexpr int kPatienceSmallViewportFrames = 30;
/// Moved frames for which what has come stays, though it would not come now: where it is too short or points at the viewer, by thresholds kDwellFactor times as high (which hold as well, while the view turns, for what would come back at one of
/// the looks ahead), or inside the model across another's extension line where it is not in plain view; and for which a line that has gone waits for a place that lasts, unless its feature is in plain view. More than a
/// change that is taken back lasts. Fewer: some are shown, or missing, for a moment only. More: they are short, or run across extension lines, for longer, and what comes into sight again is late. A lower factor: lines shrink to their arrowheads.
inline constexpr int kDwellFrames = 16;
inline constexpr double kDwellFactor = 0.5;
/// Moved frames on end without any line across another's extension line, after which a line inside the model may come out to run across one, in a zoom and not in plain view. Fewer: crowded pictures have more such lines.
/// More: lines are inside though there is room.
inline constexpr int kCalmFrames = 60;

/// rad. A frame in which the view turns by more counts as several for how long a scope has been in sight, so that a quick turn drops what it hides at once.
inline constexpr double kFrameTurnRad = 0.0174;

/// rad, and the logarithm of a ratio of sizes on screen. How much further the view is thought to turn, or to come nearer, by whoever needs a new place (placement/foresight.h), and what a
/// place costs that is lost at once then. As far as a turn goes in kReturnFrames frames of a steady movement; a zoom five times as far, since it mostly goes on until what is looked for fills the
/// picture. A shorter way ahead: lines go where they cannot stay. A higher price: they go far, or across extension lines, to last longer. No whole number of spacings: with one, places tie that
/// the score's other terms tell apart by such numbers.
inline constexpr double kForesightRad = 0.349;
inline constexpr double kForesightZoom = 1.6;
inline constexpr double kScoreSoonGone = -10.9 * kHandleSpacingPx;
/// At how many views on that way a place is looked at: the sooner it is lost, the more it costs. While the picture grows, one side of the viewport after the other has no room any more, and of places that
/// are all lost soon the one that lasts longest is wanted: there it is looked at more often, each time twice as far ahead, and what is lost costs so many times more. More looks cost time.
inline constexpr int kLooksAheadTurning = 3;
inline constexpr int kLooksAheadZooming = 6;
inline constexpr double kSoonGoneZooming = 3.5;
/// A parameter with more base lines has none between parts of the model. Fewer: more of them are on the model. More: it takes longer.
inline constexpr std::size_t kMostBaseLinesInGaps = 8;
/// Logarithm of a ratio of sizes on screen. While the camera comes nearer or goes away, one base line of a row comes before a chain whose place is lost before the picture has zoomed by this; and a switch or a choice that
/// loses its place goes inside before it goes to such a one. Less: chains are begun for a moment. More: rows have no chains.
inline constexpr double kBriefZoom = 0.7;
/// Of kLooksAheadZooming looks: a place outside the model that is lost at one of so many is not begun, and not by a line that is inside; nor is a base line inside it of which nothing is left in the picture at one of so many, when its
/// scope is not in plain view; nor is a line shown anew whose base line is out of the picture or too short at one of so many. Fewer: lines hop from one place to another for a frame or two each, or are shown at the rim, or
/// while they shrink, for their last moments. More: lines are inside though there is room, and features in view have no line.
inline constexpr std::size_t kLooksAtLastMoments = 1;
inline constexpr std::size_t kLooksAtLastMomentsComingOut = 3;
inline constexpr std::size_t kLooksAtLastMomentsInside = 4;
inline constexpr std::size_t kLooksAtLastMomentsAnew = 3;
/// What another place costs a line on a scope that is going out of sight: too little of it is seen already, and only kFramesToLoseSight keep it; from another scope it does not go there. As much as what is lost at once while the camera comes nearer. Less:
/// near a wall that is passed by, lines go from one window to the next as each is hidden.
inline constexpr double kScoreFadingScope = -30.0 * kHandleSpacingPx;
/// Moved frames for which one line stands for a chain that had no room, while the camera comes nearer or goes away; otherwise kReturnFrames. Fewer: the chain comes back where there is just room for it, and goes to
/// a better side soon after. More: it is still missing where it would be tidy.
inline constexpr int kSingleStaysZooming = 50;
/// What it costs, as a share of a lost place, that the faces which meet in a base line turn away from the viewer, each by this (sine of the angle): what stands on them is hidden soon, but not in
/// a model that can be seen through. More: lines go far, or across extension lines, to stay with what is in view.
inline constexpr double kTurnedAwayShare = 0.5;
inline constexpr double kTurnedAwaySin = 0.1;

/// rad. A view that has turned by more than this since the last frame is another picture, not the next one of a movement: what was chosen
/// for the last one is forgotten. A quick flick of the hand turns by less even at ten frames a second.
inline constexpr double kForgetTurnRad = 0.6;

/// px a frame. A line that lies further out than it must, since one nearer to the model has gone, comes nearer by this much in each moved frame, and
/// is further out than this share of what it must for some frames only: its way stays short without a jump.
inline constexpr double kRelaxPx = 6.0;
inline constexpr double kMostOffsetRatio = 1.15;
/// Further out than that it comes nearer by so many times kRelaxPx: quickly, and still no leap.
inline constexpr double kHurryFactor = 5.0;

/// Beyond the paper: a line across another's extension line misleads, two extension lines that cross do not; the first costs this more than Intersect,
/// and more than staying is worth. With one that stood there in the last frame, and may move yet, it costs the second: as much, and each would
/// flee from the other.
inline constexpr double kScoreCrossesExtension = -20.0 * kHandleSpacingPx;
inline constexpr double kScoreCrossesAhead = -6.0 * kHandleSpacingPx;

/// Beyond the paper: principle 6, shorter lines nearer to the model. The order of placing brings that about unless a shorter line had to go far out; a longer
/// one that would lie nearer, beside it, costs this. Less than kScoreStay: whoever is there already is moved by mending alone (kScoreNestedWrongly).
inline constexpr double kScoreNestsWrongly = -8.0 * kHandleSpacingPx;

/// Beyond the paper: an extension line through a label that has landed makes it hard to read, which a crossing of two thin lines does
/// not; such a place is taken only when it is much nearer than any other.
inline constexpr double kScoreCoversLabel = -6.0 * kHandleSpacingPx;
/// What it costs a pill that its thread runs across a dimension line, an extension line, another thread (where lines settle; otherwise as much as an extension line), or a label; and what it is worth that it stays where it was, against its anchor, or on that side at least.
/// A thread is thin and ends in a dot, so over lines it costs less than a line would. More for lines: pills go further for it. More for staying, or less for labels: a pill is held where its thread
/// runs across half the drawing; the other way round: it changes sides more often on an orbit.
inline constexpr double kScoreThreadOverLine = -2.0 * kHandleSpacingPx;
inline constexpr double kScoreThreadOverExtension = -0.5 * kHandleSpacingPx;
inline constexpr double kScoreThreadOverThread = -4.0 * kHandleSpacingPx;
inline constexpr double kScoreThreadOverLabel = -10.0 * kHandleSpacingPx;
inline constexpr double kScorePillStays = 40.0 * kHandleSpacingPx;
inline constexpr double kScorePillStaysOnSide = 2.0 * kHandleSpacingPx;
/// Of the viewport's shorter side, how long the thread to a new place of a pill may be; to one further away it goes only when there is none on the model. Shorter: pills cover what could be seen. Longer: in a row of trees
/// a pill stands beside another tree than its own.
inline constexpr double kLongestThreadShare = 0.4;
/// px of score by which a place must be better, but for labels in its way, than the one that is chosen, for those labels to be asked to give way. Less: they give way, or are left out, for
/// nothing. More: lines go behind the model for the sake of a number that could stand elsewhere.
inline constexpr double kWorthAskingPx = 3.0 * kHandleSpacingPx;

/// Beyond the paper: a place that brings a line within handleSpacing of where a later one stood in the last frame pushes that one away, and what comes after
/// it as well; it costs this much. More: short lines wander far out to leave long ones alone. Less: more changes come in cascades.
inline constexpr double kScoreCrowdsAhead = -2.0 * kHandleSpacingPx;
/// Likewise for a place between a later line and every viewport edge from which it was seen: the fields are one-dimensional, so that line must go all round
/// this one, which is a leap.
inline constexpr double kScoreShadowsAhead = -2.0 * kHandleSpacingPx;
/// px. A line that would move by more than this against its base line in one frame has no reason to stay (kScoreStay): a leap disturbs as much as another place.
inline constexpr double kLeapPx = 40.0;
inline constexpr double kScorePlane = 3.0 * kHandleSpacingPx;            ///< lambda 6

/// per px. Beyond the paper: a line that has slid along itself, since its extension lines lead askew to it, lies beside another part of the model than its own and seems to measure that; such a px costs so much more
/// than one straight away from the base line. More: lines go to edges that the model hides, or across extension lines, to lie beside their own.
inline constexpr double kScoreAskew = -1.0;

/// per px. Beyond the paper: extension lines that run over the model, as over a roof to what is behind it, hide it and seem to measure what they run over; where lines settle such a px costs so much
/// more than one beside the model. More: lines go round others, far out, to stay on the side that faces the viewer. Not while the camera moves: what is the shorter way over the model changes with each degree.
inline constexpr double kScoreOverModel = -2.0;

/// per px. Beyond the paper: what it costs there that extension lines bend (paper 5), of the way from the base line to the bend: with a kink it is harder to follow where they come from. More: lines go further for a plane that
/// their base line lies in.
inline constexpr double kScoreBent = -1.0;

/// Beyond the paper: what it costs there that members of a chain are hidden, all of them; of some, in proportion. A row at the far side, of which one shows past a corner, says less than one in front. More: chains go far out for
/// a row that is seen as a whole.
inline constexpr double kScoreHiddenMembers = -5.0 * kHandleSpacingPx;

// --- Geometry ---------------------------------------------------------------------------------------------------------

/// rad. Planes whose normal is within this of a right angle to the view direction are left out (paper 4.4): seen
/// edge-on, a line on them runs far across the screen for a small move.
inline constexpr double kEdgeOnAngleRad = 0.1;

/// rad and share of the model's size: planes, and directions, that agree within these are the same (guides, chains).
inline constexpr double kSamePlaneAngleRad = 1e-4;
inline constexpr double kSamePlaneDistance = 1e-4;

// --- Visibility of scopes ---------------------------------------------------------------------------------------------

/// Samples along the longer side of the CPU's depth buffer. A quarter of a large viewport: a scope of 10 px still has a few samples.
inline constexpr int kVisibilitySamples = 384;

/// Share of the model's size by which a scope's box may lie behind the model's surface and still count as seen: window boxes reach into
/// the wall, and facades stand a little before their scopes. Too small hides what is plainly there, too large shows it through thin walls.
inline constexpr double kScopeSkinShare = 0.01;

/// The same for a single edge that is drawn over the picture: less, since an edge a brick behind a wall would shine through.
inline constexpr double kEdgeSkinShare = 0.3 * kScopeSkinShare;

/// Share of the viewport that is plenty to see: a scope that covers more is judged as if it covered this much, so that a house of which a whole wall shows is not
/// hidden for its other walls.
inline constexpr double kPlentySeenShare = 0.003;

/// Share of a scope's screen area that must be seen for it to be shown, and below which one that is shown is dropped again. Two
/// thresholds, so that a scope at the edge of sight does not flicker. One that went out of sight within kReturnFrames moved frames must be seen by
/// half to be shown again: behind leaves the share leaps from frame to frame.
inline constexpr double kSeenShareToShow = 0.12;
inline constexpr double kSeenShareToKeep = 0.06;
inline constexpr double kSeenShareToShowAgain = 0.5;
/// Shares of a scope that are seen where it is in plain view; the lower one for a line inside that is shown already, since behind sails and leaves the share leaps. Where less is seen, a line inside, and while the
/// camera comes nearer or goes away a new one outside, is not shown across others' extension lines. Higher: more lines are missing. Lower: features that are nearly hidden clutter the picture.
inline constexpr double kSeenShareInPlainView = 0.5;
inline constexpr double kSeenShareToStayInPlainView = 0.3;

/// Moved frames on end in which too little of a scope is seen before it counts as hidden. Behind leaves, and where a wall is seen at a grazing angle, a scope has few
/// samples and a frame without any means little. Fewer: lines leave their features more often. More: a line stays long after its feature went out of sight.
inline constexpr int kFramesToLoseSight = 8;

// --- Camera -----------------------------------------------------------------------------------------------------------

/// The near plane as a share of the distance to the model's farthest point. 24-bit depth keeps about 1e-4 of that
/// distance at the far end; nearer things are cut away.
inline constexpr double kNearShare = 1e-3;

/// rad. The vertical field of view of a page that just opened. 35 degrees is near what architects' photographs use:
/// wide enough to feel solid, narrow enough to keep verticals calm.
inline constexpr double kDefaultFovRad = 0.6108652381980153;

// --- Interaction ------------------------------------------------------------------------------------------------------

/// px. How far from an arrowhead's middle a mouse, or a finger, still takes hold of it. 44 px targets for touch
/// (WCAG 2.2, 2.5.5), where neighbours allow: the nearest handle wins.
inline constexpr double kGrabRadiusMousePx = 14.0;
inline constexpr double kGrabRadiusTouchPx = 26.0;

/// px. How far from a line, between its arrowheads, a mouse still points at it. Larger: lines light up under a mouse that is on its way elsewhere.
inline constexpr double kPointAtPx = 6.0;

}  // namespace dimline
